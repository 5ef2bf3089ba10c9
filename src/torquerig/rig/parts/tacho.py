"""A tacho on any shaft: one pulse per tooth, slot or reflector."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.turns import turns_per_motor_turn
from torquerig.sensor_stages.tacho import Tacho


@dataclass(frozen=True, kw_only=True)
class TachoSensor(Part):
    """Pulses of ``theta pulses_per_rev / 2 pi``, high for a share ``duty`` of each, as a further channel.

    ``teeth`` is another word for ``pulses_per_rev``: a wheel gives one pulse per tooth. The sidecar of the recording
    states the pulses per turn of the motor. The elastic twist between the motor and ``at`` is not in the pulses, and
    they have no direction. Source: the definition of a tacho; signatures.md 0 (angle from pulses).
    """

    kind: Literal["tacho"] = "tacho"
    at: str = "motor"
    pulses_per_rev: Annotated[float, Parameter("1", "pulses per turn of the shaft; 0: the teeth say", low=0)] = 0.0
    teeth: int = 0
    high: Annotated[float, Parameter("V", "level of a pulse", above=0)] = 5.0
    duty: Annotated[float, Parameter("1", "share of a pulse that is high", above=0, high=1)] = 0.5

    def __post_init__(self) -> None:
        if self.teeth < 0 or (self.pulses_per_rev > 0) == (self.teeth > 0):
            raise ValueError("a tacho needs its pulses per turn; state either pulses_per_rev or teeth, more than 0")

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the pulses; InputError where no shaft leads from the motor to ``at``."""
        turns = abs(turns_per_motor_turn(rig, self.at))
        stage = Tacho(
            pulses_per_motor_turn=(self.pulses_per_rev or self.teeth) * turns, high=self.high, duty=self.duty,
            channel=self.name,
        )  # fmt: skip
        return (PlacedStage(position=PlacedStage.FILE, stage=stage),)
