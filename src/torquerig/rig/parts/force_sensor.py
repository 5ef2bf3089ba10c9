"""A force sensor: a spring in the line, an amplifier, noise and a converter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import GuidedPart
from torquerig.rig.host_changes import IN_A_SENSOR, IN_A_SPRING, HostChange, lowest_cutoff
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.sensor_reading import Mounting, refuse_zero_of_tared, scale_and_zero
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term
from torquerig.sensor_stages.amplifier import AmplifierLowPass
from torquerig.sensor_stages.converter import Converter
from torquerig.sensor_stages.noise import WhiteNoise


@dataclass(frozen=True, kw_only=True)
class ForceSensor(GuidedPart):
    """The torque sensor for motion in a line: force of spring and damper, low-pass, noise, codes.

    ``scale``, ``zero``, their tolerances, ``tare`` and ``mounting`` are those of a torque_sensor.
    """

    is_sensor: ClassVar[bool] = True
    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    in_a_line: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = (*IN_A_SPRING, *IN_A_SENSOR)

    kind: Literal["force_sensor"] = "force_sensor"
    stiffness: Annotated[float, Parameter("N/m", "stiffness", above=0)]
    damping: Annotated[float, Parameter("N*s/m", "damping", low=0)]
    mass: Annotated[float, Parameter("kg", "mass of the far side", low=0)]
    sensitivity: Annotated[float, Parameter("V/N", "output per force", above=0)] = 1.0
    bandwidth: Annotated[float, Parameter("Hz", "amplifier bandwidth at -3 dB", above=0)]
    noise_rms: Annotated[float, Parameter("V", "rms of the noise", low=0)] = 0.0
    converter_range: Annotated[float, Parameter("V", "converter range, plus and minus", above=0)] = 10.0
    converter_bits: int = 16
    scale: Annotated[float, Parameter("1", "true sensitivity over the stated one", above=0)] = 1.0
    gain_tolerance: Annotated[float, Parameter("1", "largest relative error of the sensitivity", low=0, high=1)] = 0.0
    zero: Annotated[float, Parameter("N", "reading without a load")] = 0.0
    zero_tolerance: Annotated[float, Parameter("N", "largest error of the zero", low=0)] | None = None
    tare: bool = False
    mounting: Mounting = "forward"

    def __post_init__(self) -> None:
        refuse_zero_of_tared(tare=self.tare, zero=self.zero, name=self.name)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the spring, and mass and friction of its far side."""
        spring = stage_spring(rig, self.name, stiffness=self.stiffness, damping=self.damping)
        return Inertia(node=spring.b, inertia=self.mass), spring, *self.friction_on(spring.b)

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return scale and zero, amplifier, noise and converter."""
        cutoff = lowest_cutoff(self.bandwidth, rig.changes_in(self.name))
        converter = Converter(range_V=self.converter_range, bits=self.converter_bits)
        return (
            *scale_and_zero(scale=self.scale, zero=self.zero),
            PlacedStage(position=PlacedStage.AMPLIFIER, stage=AmplifierLowPass(cutoff=cutoff)),
            PlacedStage(position=PlacedStage.NOISE, stage=WhiteNoise(rms=self.noise_rms)),
            PlacedStage(position=PlacedStage.CONVERTER, stage=converter),
        )
