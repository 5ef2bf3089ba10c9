"""Six-step commutation: a brushless DC motor's six dips per electrical turn, out of its phases and DC link."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, HostChange
from torquerig.rig.parts.motor_phases import phases_of
from torquerig.rig.phase_level import as_waves, lines_at_set_point
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class SixStepCommutation(Part):
    """Lines of order 6p and its multiples that grow with the torque; they follow from the machine's data.

    Two phases carry the current for 60 electrical degrees, and each change of pair takes the time that the DC link
    needs to move the current over: the lines are those of the phase-level run (``machines/six_step.py``) at speed and
    mean torque of the set-point, and stay so in a ramp. A variant of commutation_ripple. Source: Carlson,
    Lajoie-Mazenc & Fagundes 1992, IEEE Trans. Industry Applications 28(3). Switching ripple is not in here.
    """

    kind: Literal["six_step_commutation"] = "six_step_commutation"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the drive carries the ripple; InputError where nothing is known of the motor's phases."""
        phases_of(rig, self.at)
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the ripple of the motor's torque."""
        phases = phases_of(rig, self.at)
        return (DriveRipple(as_waves(lines_at_set_point(rig, phases, phases.six_step()))),)
