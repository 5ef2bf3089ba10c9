"""A current sensor in the supply of a motor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts.motor_phases import MotorPhases
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.sensor_reading import Mounting, reading_stages, refuse_zero_of_tared
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class CurrentSensor(Part):
    """The current [A] that makes the motor's torque: ``torque / torque_constant``, ripple and friction not in it.

    It writes a channel where ``measured:`` names it. ``scale``, ``zero``, their tolerances, ``tare`` and ``mounting``
    are those of a torque_sensor. Without a ``bandwidth`` it has no low-pass.
    """

    is_sensor: ClassVar[bool] = True

    kind: Literal["current_sensor"] = "current_sensor"
    at: str = "motor"
    torque_constant: Annotated[float, Parameter("N*m/A", "torque per current", above=0)] | None = None
    bandwidth: Annotated[float, Parameter("Hz", "bandwidth at -3 dB, second order", above=0)] | None = None
    noise_rms: Annotated[float, Parameter("A", "rms of the noise", low=0)] = 0.0
    scale: Annotated[float, Parameter("1", "true sensitivity over the stated one", above=0)] = 1.0
    gain_tolerance: Annotated[float, Parameter("1", "largest relative error of the sensitivity", low=0, high=1)] = 0.0
    zero: Annotated[float, Parameter("A", "reading at rest")] = 0.0
    zero_tolerance: Annotated[float, Parameter("A", "largest error of the zero", low=0)] | None = None
    tare: bool = False
    mounting: Mounting = "forward"

    def __post_init__(self) -> None:
        refuse_zero_of_tared(tare=self.tare, zero=self.zero, name=self.name)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return nothing; InputError where nothing drives ``at``, or its torque constant is nowhere stated."""
        self.newton_metres_per_ampere(rig)
        return ()

    def newton_metres_per_ampere(self, rig: Rig) -> float:
        """Return the stated torque constant, else that of the motor's phases, per ampere of peak phase current."""
        rig.node(self.at)
        if self.torque_constant is not None:
            return self.torque_constant
        for part in rig.parts_of(MotorPhases):
            if part.motor == self.at:
                return part.torque_per_ampere
        raise InputError(
            f"{self.name}: a current needs the torque constant of {self.at!r}; add torque_constant:, such as "
            "0.11 N*m/A, or a part of kind motor_phases"
        )

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return scale and zero, low-pass and noise."""
        return reading_stages(scale=self.scale, zero=self.zero, bandwidth=self.bandwidth, noise_rms=self.noise_rms)
