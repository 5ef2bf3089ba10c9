"""Hall misplacement: sensors that switch too early or too late make the six sectors unequal."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, HostChange
from torquerig.rig.parts.motor_phases import phases_of
from torquerig.rig.phase_level import as_waves, lines_at_set_point
from torquerig.rig.terms import Term

Angle = Annotated[float, Parameter("rad", "electrical angle", low=-pi / 6, high=pi / 6)]


@dataclass(frozen=True, kw_only=True)
class HallMisplacement(Part):
    """What misplaced sensors a, b, c add to six-step commutation: with it minus without it, line by line.

    ``shift`` moves both edges of a sensor, which repeats every half electrical turn: orders 2p, 4p and a changed 6p;
    an equal shift of all three keeps the sectors equal and only changes 6p. ``width`` lengthens the high state
    (unequal poles of the sensor's magnet), which repeats every electrical turn: orders p, 2p, 3p. The lines are those
    of the phase-level run at the set-point, in proportion to the torque. A variant of commutation_ripple.

    Source: signatures.md 1.5 (Pillay & Krishnan 1989, IEEE Trans. Industry Applications 25(2)). Poles of the sensor's
    magnet that differ among each other (orders 1, 2, ...) are not in here.
    """

    kind: Literal["hall_misplacement"] = "hall_misplacement"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    shift: tuple[Angle, Angle, Angle] = (0.0, 0.0, 0.0)
    width: tuple[Angle, Angle, Angle] = (0.0, 0.0, 0.0)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the drive carries the ripple; InputError where nothing is known of the motor's phases."""
        phases_of(rig, self.at).six_step(hall_shift=self.shift, hall_width=self.width)
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the ripple with the misplacement less that without it."""
        if not any((*self.shift, *self.width)):
            return ()
        phases = phases_of(rig, self.at)
        right = lines_at_set_point(rig, phases, phases.six_step())
        wrong = lines_at_set_point(rig, phases, phases.six_step(hall_shift=self.shift, hall_width=self.width))
        added = {order: wrong.get(order, 0) - right.get(order, 0) for order in {*right, *wrong}}
        return (DriveRipple(as_waves(added)),)
