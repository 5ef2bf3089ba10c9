"""Sensor drift: the zero moves while the sensor warms up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.drift import Drift


@dataclass(frozen=True, kw_only=True)
class SensorDrift(Part):
    """``V += s (1 - exp(-t / tau))``, or a straight line to s at the end of the recording where tau is not stated.

    Source: VDI/VDE 2646, DIN 51309 (0.05 to 0.5 % of full scale in 10 K). Not valid where several masses warm up one
    after the other.
    """

    kind: Literal["sensor_drift"] = "sensor_drift"
    group: Literal["sensor"] = "sensor"
    span: Annotated[float, Parameter("V", "asymptote, or the end of the straight line")]
    time_constant: Annotated[float, Parameter("s", "time constant of the warm-up", above=0)] | None = None

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the drift."""
        drift = Drift(span=self.span, time_constant=self.time_constant)
        return (PlacedStage(position=PlacedStage.CABLE, stage=drift),)
