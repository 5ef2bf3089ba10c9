"""A speed sensor on any shaft or part in a line: a tachogenerator, a rate of an encoder's counter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.sensor_reading import Mounting, reading_stages, refuse_zero_of_tared
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class SpeedSensor(Part):
    """The speed [rad/s], in a line the velocity [m/s], of the part ``at``.

    It writes a channel where ``measured:`` names it. ``scale``, ``zero``, their tolerances, ``tare`` and ``mounting``
    are those of a torque_sensor. Without a ``bandwidth`` it has no low-pass.
    """

    is_sensor: ClassVar[bool] = True

    kind: Literal["speed_sensor"] = "speed_sensor"
    at: str
    bandwidth: Annotated[float, Parameter("Hz", "bandwidth at -3 dB, second order", above=0)] | None = None
    noise_rms: Annotated[float, Parameter("rad/s", "rms of the noise", low=0)] = 0.0
    scale: Annotated[float, Parameter("1", "true sensitivity over the stated one", above=0)] = 1.0
    gain_tolerance: Annotated[float, Parameter("1", "largest relative error of the sensitivity", low=0, high=1)] = 0.0
    zero: Annotated[float, Parameter("rad/s", "reading at rest")] = 0.0
    zero_tolerance: Annotated[float, Parameter("rad/s", "largest error of the zero", low=0)] | None = None
    tare: bool = False
    mounting: Mounting = "forward"

    def __post_init__(self) -> None:
        refuse_zero_of_tared(tare=self.tare, zero=self.zero, name=self.name)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return nothing; UnknownNameError where there is no such shaft."""
        rig.node(self.at)
        return ()

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return scale and zero, low-pass and noise."""
        return reading_stages(scale=self.scale, zero=self.zero, bandwidth=self.bandwidth, noise_rms=self.noise_rms)
