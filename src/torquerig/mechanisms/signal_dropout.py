"""Signal dropout: the reading is lost for milliseconds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.dropout import Dropout


@dataclass(frozen=True, kw_only=True)
class SignalDropout(Part):
    """``V = level`` for ``duration``, at moments that follow one another at random (Poisson), ``rate`` on average.

    Source: signatures.md 6.10 (telemetry, slip rings: 0 to 1 % of the samples). Not valid for a slip ring whose worn
    spot comes round once a turn.
    """

    kind: Literal["signal_dropout"] = "signal_dropout"
    group: Literal["sensor"] = "sensor"
    duration: Annotated[float, Parameter("s", "length of a dropout", low=0)]
    rate: Annotated[float, Parameter("1/s", "dropouts in a second, as in 12 per minute", low=0)]
    level: Annotated[float, Parameter("V", "reading during a dropout")] = 0.0

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the dropouts."""
        lost = Dropout(duration=self.duration, rate=self.rate, level=self.level, source=self.name)
        return (PlacedStage(position=PlacedStage.INPUT, stage=lost),)
