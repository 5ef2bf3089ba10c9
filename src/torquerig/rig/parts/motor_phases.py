"""The phases of a permanent-magnet motor and the inverter that feeds them: which determine its electrical ripple."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi
from typing import TYPE_CHECKING, Annotated, Any, Literal

from torquerig.errors import InputError
from torquerig.machines.back_emf import HarmonicEmf, TrapezoidalEmf
from torquerig.machines.current_loop import check_bandwidth, loop_admittance
from torquerig.machines.permanent_magnet import PermanentMagnetMachine
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig

if TYPE_CHECKING:
    from torquerig.machines.field_oriented import FieldOriented
    from torquerig.machines.six_step import SixStep

Share = Annotated[float, Parameter("1", "share of the fundamental, negative where turned by half a period")]


@dataclass(frozen=True, kw_only=True)
class MotorPhases(Part):
    """Data for effects of commutation and current control; it adds nothing to the shafts.

    ``v = R i + L di/dt + e`` per phase, star point free. The back-EMF is a trapezoid where ``flat_angle`` is stated,
    else a sine with ``emf_harmonics`` (odd orders, in phase with the fundamental at its rising zero).
    ``flux_linkage`` is the peak of the sine, or the flat top, over the electrical speed. Where the machine is linear
    and not salient: see ``machines/permanent_magnet.py``.
    """

    kind: Literal["motor_phases"] = "motor_phases"
    motor: str = "motor"
    pole_pairs: int
    phase_resistance: Annotated[float, Parameter("ohm", "resistance of one phase", above=0)]
    phase_inductance: Annotated[float, Parameter("H", "inductance of one phase", above=0)]
    flux_linkage: Annotated[float, Parameter("V*s", "flux linkage per electrical radian", above=0)]
    dc_link: Annotated[float, Parameter("V", "DC-link voltage", above=0)]
    current_loop_bandwidth: Annotated[float, Parameter("Hz", "bandwidth of the current loop", above=0)] = 500.0
    control_period: Annotated[float, Parameter("s", "sampling and switching period", above=0)] = 40e-6
    flat_angle: Annotated[float, Parameter("rad", "flat top, electrical", above=0, high=0.999 * pi)] | None = None
    emf_harmonics: dict[int, Share] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.pole_pairs < 1:
            raise ValueError(f"{self.pole_pairs} pole pairs cannot be; write at least 1")
        if self.flat_angle is not None and self.emf_harmonics:
            raise ValueError("state flat_angle or emf_harmonics: a trapezoid has its harmonics already")
        HarmonicEmf({1: 1.0, **self.emf_harmonics})
        check_bandwidth(self.current_loop_bandwidth, period=self.control_period)

    @property
    def torque_per_ampere(self) -> float:
        """Torque per ampere of peak phase current of a sinusoidal machine, 3/2 p lambda [N*m/A]."""
        return 1.5 * self.pole_pairs * self.flux_linkage

    def machine(self, **changes: Any) -> PermanentMagnetMachine:
        """Return the phase-level machine; ``changes`` are fields of it."""
        harmonics = HarmonicEmf({1: 1.0, **self.emf_harmonics})
        own = {
            "pole_pairs": self.pole_pairs,
            "phase_resistance": self.phase_resistance,
            "phase_inductance": self.phase_inductance,
            "flux_linkage": self.flux_linkage,
            "back_emf": harmonics if self.flat_angle is None else TrapezoidalEmf(self.flat_angle),
        }
        return PermanentMagnetMachine(**{**own, **changes})

    def six_step(self, **errors: Any) -> SixStep:
        """Return six-step commutation from this inverter; ``errors`` are those of the Hall sensors."""
        from torquerig.machines.six_step import SixStep

        return SixStep(
            dc_link=self.dc_link, period=self.control_period, bandwidth=self.current_loop_bandwidth, **errors
        )

    def field_oriented(self, **errors: Any) -> FieldOriented:
        """Return field-oriented control from this inverter; ``errors`` are those of drive and sensors."""
        from torquerig.machines.field_oriented import FieldOriented

        return FieldOriented(
            dc_link=self.dc_link, period=self.control_period, bandwidth=self.current_loop_bandwidth, **errors
        )

    def admittance(self, frequency: float) -> complex:
        """Return the current per volt [A/V] that a disturbance of ``frequency`` [Hz] drives through the loop."""
        return loop_admittance(
            resistance=self.phase_resistance,
            inductance=self.phase_inductance,
            bandwidth=self.current_loop_bandwidth,
            frequency=frequency,
        )


def phases_of(rig: Rig, motor: str) -> MotorPhases:
    """Return the phases of the motor part ``motor``; InputError where the rig states none."""
    rig.part(motor)
    for part in rig.parts_of(MotorPhases):
        if part.motor == motor:
            return part
    raise InputError(
        f"{motor}: nothing is stated of its phases; add a part of kind motor_phases with resistance, inductance, "
        "flux linkage and DC link, or ripple: from_phase_level to a motor of the catalog"
    )
