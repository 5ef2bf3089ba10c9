"""What speed, acceleration and current sensors share: they read at a part, add nothing to it, and write the SI unit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.sensor_reading import Mounting, reading_stages, refuse_zero_of_tared
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class PointSensor(Part):
    """A sensor ``at`` a part: it writes a channel where ``measured:`` names it.

    ``scale``, ``zero``, their tolerances, ``tare`` and ``mounting`` are those of a torque_sensor. Without a
    ``bandwidth`` it has no low-pass. Each kind declares ``noise_rms``, ``zero`` and ``zero_tolerance`` in its unit.
    """

    is_sensor: ClassVar[bool] = True

    at: str
    bandwidth: Annotated[float, Parameter("Hz", "bandwidth at -3 dB, second order", above=0)] | None = None
    noise_rms: float = 0.0
    scale: Annotated[float, Parameter("1", "true sensitivity over the stated one", above=0)] = 1.0
    gain_tolerance: Annotated[float, Parameter("1", "largest relative error of the sensitivity", low=0, high=1)] = 0.0
    zero: float = 0.0
    zero_tolerance: float | None = None
    tare: bool = False
    mounting: Mounting = "forward"

    def __post_init__(self) -> None:
        refuse_zero_of_tared(tare=self.tare, zero=self.zero, name=self.name)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return nothing; UnknownNameError where there is no such part."""
        rig.node(self.at)
        return ()

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return scale and zero, low-pass and noise."""
        return reading_stages(scale=self.scale, zero=self.zero, bandwidth=self.bandwidth, noise_rms=self.noise_rms)
