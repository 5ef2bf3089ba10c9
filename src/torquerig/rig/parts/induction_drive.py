"""An induction motor on its supply or a plain inverter: its speed falls with load by the slip."""

from __future__ import annotations

from dataclasses import dataclass
from math import copysign, pi, sqrt
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.machines.induction import InductionMachine, induction_from_rating
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, waves_of
from torquerig.rig.parts.motor import Motor
from torquerig.rig.terms import Drive, Term


@dataclass(frozen=True, kw_only=True)
class InductionDrive(Part):
    """``T = 2 Tb x / (1 + x^2)``, x the slip speed over that of breakdown (Kloss), from the name plate.

    The set-point of the run (``motor_speed``, ``speed_rpm``) is the speed of the field, not of the shaft: 1500 rpm is a
    motor of two pole pairs on 50 Hz; the shaft turns slower by the slip of its load, counted here once. An
    inverter that keeps the flux by voltage over frequency. The slip speed of a torque stays the same then. The torque
    follows the slip with ``1 / (sb 2 pi f)``, the time constant of the rotor's flux on its leakage.

    Source: Kloss 1909; Boldea & Nasar, The Induction Machine Handbook, chapter 7. Not true above the rated frequency
    (weaker field), where the stator's resistance counts (a few hertz), and during a start, when the mains' current
    makes torque at 50 Hz; ``machines/induction_run.py`` has those.
    """

    kind: Literal["induction_drive"] = "induction_drive"
    motor: str = "motor"
    pole_pairs: int
    rated_torque: Annotated[float, Parameter("N*m", "rated torque", above=0)]
    rated_speed: Annotated[float, Parameter("rad/s", "rated speed", above=0)]
    breakdown_torque: Annotated[float, Parameter("N*m", "breakdown torque", above=0)]
    rated_frequency: Annotated[float, Parameter("Hz", "frequency that the rating holds for", above=0)] = 50.0

    def __post_init__(self) -> None:
        if self.pole_pairs < 1:
            raise ValueError(f"{self.pole_pairs} pole pairs cannot be; write at least 1")
        try:
            self.machine()
        except InputError as error:
            raise ValueError(str(error)) from None

    def machine(self) -> InductionMachine:
        """Return the phase-level machine at its rated frequency."""
        return induction_from_rating(
            rated_torque=self.rated_torque,
            rated_speed=self.rated_speed,
            breakdown_ratio=self.breakdown_torque / self.rated_torque,
            pole_pairs=self.pole_pairs,
            supply_frequency=self.rated_frequency,
        )

    def slip_speed(self, torque: float) -> float:
        """Return how much slower than the field the rotor turns [rad/s] at a torque [N m]; beyond breakdown as at it.

        Kloss solved for the stable branch: ``x = y - sqrt(y^2 - 1)``, y the breakdown torque over the torque.
        """
        machine = self.machine()
        breakdown = machine.breakdown_slip * machine.synchronous_speed
        if torque == 0:
            return 0.0
        over = max(self.breakdown_torque / abs(torque), 1.0)
        return copysign(breakdown * (over - sqrt(over**2 - 1)), torque)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the drive of the motor."""
        motor = rig.part(self.motor)
        if not isinstance(motor, Motor):
            raise InputError(f"{self.name}: motor: {self.motor!r} is no motor; name one")
        machine = self.machine()
        breakdown = machine.breakdown_slip * machine.synchronous_speed
        return (
            Drive(
                name=self.name,
                on=rig.node(self.motor),
                kp=2 * self.breakdown_torque / breakdown,
                ki=0.0,
                torque_limit=self.breakdown_torque,
                lag=1 / (machine.breakdown_slip * 2 * pi * self.rated_frequency),
                breakdown=breakdown,
                ripple=waves_of(rig.changes_in(self.motor), DriveRipple),
            ),
        )
