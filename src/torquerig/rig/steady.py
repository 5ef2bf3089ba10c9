"""Mean torques in steady running at the set-point, from loads, friction and gears."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.drive_train import DriveTrain, drive_train, passive_terms, places_from, springs_of


def steady_torque(rig: Rig, motor: str) -> float:
    """Return the mean torque of the motor part ``motor`` at the set-point of the run [N m].

    Every load and friction at its node's mean speed, through the gears on the way; see
    :class:`torquerig.rig.drive_train.DriveTrain` for what is left out. Zero where the run states no speed.
    """
    return drive_train(rig, rig.node(motor)).steady_torque(rig.run.speed or 0.0)


def steady_torque_in(rig: Rig, spring: str, *, motor: str) -> float:
    """Return the mean torque that the gear or coupling ``spring`` transmits to its output at the set-point [N m].

    What stands behind it, seen from ``motor``; the same things are left out as in :func:`steady_torque`.
    """
    terms = passive_terms(rig)
    springs = springs_of(terms)
    crossed = next(term for term in springs if term.name == spring)
    from_motor = places_from(rig.node(motor), springs)
    if crossed.b not in from_motor:
        return 0.0
    behind = places_from(crossed.b, [term for term in springs if term.name != spring])
    speed = (rig.run.speed or 0.0) * from_motor[crossed.b].ratio
    return DriveTrain(terms=terms, places=behind).steady_torque(speed)
