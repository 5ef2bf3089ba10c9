"""The measuring chain that a torque_sensor and a reaction_torque_sensor share: amplifier, noise and converter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import IN_A_SENSOR, HostChange, lowest_cutoff
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.sensor_reading import Mounting, refuse_zero_of_tared, scale_and_zero
from torquerig.sensor_stages.amplifier import AmplifierLowPass
from torquerig.sensor_stages.converter import Converter
from torquerig.sensor_stages.noise import WhiteNoise


@dataclass(frozen=True, kw_only=True)
class AmplifiedTorqueSensor(Part):
    """The reading is the torque in the spring and damper together, through the amplifier's second-order low-pass.

    Noise is white, added after the amplifier and before the converter. An effect may leave the amplifier a lower cutoff
    than ``bandwidth``; there is one low-pass in any case, at the lowest.

    Parameters
    ----------
    scale, gain_tolerance
        True over stated sensitivity, and by what share the data sheet permits it to be off (plus and minus).
    zero, zero_tolerance
        Reading without a load, and within what it is known; not known at all where no tolerance is stated.
    tare : bool
        The zero was set before the runs.
    mounting : {"forward", "reversed"}
        Reversed, it reads a torque that drives as negative.
    """

    is_sensor: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SENSOR

    stiffness: Annotated[float, Parameter("N*m/rad", "torsional stiffness", above=0)]
    damping: Annotated[float, Parameter("N*m*s/rad", "torsional damping", low=0)]
    sensitivity: Annotated[float, Parameter("V/(N*m)", "output per torque", above=0)] = 1.0
    bandwidth: Annotated[float, Parameter("Hz", "amplifier bandwidth at -3 dB", above=0)]
    noise_rms: Annotated[float, Parameter("V", "rms of the noise", low=0)] = 0.0
    noise_colour: Annotated[
        float, Parameter("1", "correlation of neighbouring noise samples", low=-0.99, high=0.99)
    ] = 0.0
    converter_range: Annotated[float, Parameter("V", "converter range, plus and minus", above=0)] = 10.0
    converter_bits: int = 16
    scale: Annotated[float, Parameter("1", "true sensitivity over the stated one", above=0)] = 1.0
    gain_tolerance: Annotated[float, Parameter("1", "largest relative error of the sensitivity", low=0, high=1)] = 0.0
    zero: Annotated[float, Parameter("N*m", "reading without a load")] = 0.0
    zero_tolerance: Annotated[float, Parameter("N*m", "largest error of the zero", low=0)] | None = None
    tare: bool = False
    mounting: Mounting = "forward"

    def __post_init__(self) -> None:
        refuse_zero_of_tared(tare=self.tare, zero=self.zero, name=self.name)

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return scale and zero, amplifier, noise and converter."""
        cutoff = lowest_cutoff(self.bandwidth, rig.changes_in(self.name))
        return (
            *scale_and_zero(scale=self.scale, zero=self.zero),
            PlacedStage(position=PlacedStage.AMPLIFIER, stage=AmplifierLowPass(cutoff=cutoff)),
            PlacedStage(position=PlacedStage.NOISE, stage=WhiteNoise(rms=self.noise_rms, colour=self.noise_colour)),
            PlacedStage(
                position=PlacedStage.CONVERTER,
                stage=Converter(range_V=self.converter_range, bits=self.converter_bits),
            ),
        )
