"""Field-oriented control: torque lines of a servo, from its machine, current loop and sensor errors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, HostChange
from torquerig.rig.parts.motor_phases import phases_of
from torquerig.rig.phase_level import as_waves, lines_at_set_point
from torquerig.rig.terms import Term

Offset = Annotated[float, Parameter("A", "offset of a current sensor")]
Gain = Annotated[float, Parameter("1", "relative gain error of a current sensor", above=-1)]


@dataclass(frozen=True, kw_only=True)
class FieldOrientedControl(Part):
    """A sinusoidal machine without errors has no line at all; back-EMF harmonics, dead time and sensors make theirs.

    The lines are those of the phase-level run (``machines/field_oriented.py``) at speed and mean torque of the
    set-point: order 6p from back-EMF harmonics and dead time, p from offsets, 2p from unequal gains. They are given to
    the drive in proportion to its torque, although dead time and offsets do not grow with it: true near the mean
    torque. A variant of commutation_ripple.

    Source: Jahns & Soong 1996, IEEE Trans. Industrial Electronics 43(2).
    """

    kind: Literal["field_oriented_control"] = "field_oriented_control"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    dead_time: Annotated[float, Parameter("s", "dead time of a leg that nothing compensates", low=0)] = 0.0
    current_offset: tuple[Offset, Offset] = (0.0, 0.0)
    current_gain: tuple[Gain, Gain] = (0.0, 0.0)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the drive carries the ripple; InputError where nothing is known of the motor's phases."""
        phases_of(rig, self.at)
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the ripple of the motor's torque."""
        phases = phases_of(rig, self.at)
        errors = {name: getattr(self, name) for name in ("dead_time", "current_offset", "current_gain")}
        return (DriveRipple(as_waves(lines_at_set_point(rig, phases, phases.field_oriented(**errors)))),)
