"""Turns of a shaft relative to the motor whose true angle a simulation records."""

from __future__ import annotations

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Drive, ImposedMotion, Inertia


def turns_per_motor_turn(rig: Rig, name: str) -> float:
    """Return the turns of the shaft of the part ``name`` per turn of the channel ``true_motor_angle_rad`` [1].

    Negative behind a reversing gear. The elastic twist of the shafts between is not in it; with 3 N m on 1000 N m/rad
    that is 0.2 degrees. InputError where no shaft leads from the motor to the part.
    """
    terms = [term for part in rig.parts for term in rig.terms_of(part)]
    driven = [term.on for kind in (Drive, ImposedMotion) for term in terms if isinstance(term, kind)]
    carried = [term.node for term in terms if isinstance(term, Inertia) and term.inertia > 0]
    if not carried:
        raise InputError("the rig has no inertia at all; add a motor or a body")
    start = (driven or carried)[0]
    ratios = rig.speed_ratios(start)
    if rig.node(name) not in ratios:
        raise InputError(f"no shaft leads from {start!r} to {name!r}; link them with after:")
    return ratios[rig.node(name)]
