"""What a rig asks of its motor in steady running: the torque at the set-point, from loads, friction and gears."""

from __future__ import annotations

from math import exp, tanh
from typing import NamedTuple

from torquerig.rig.parts.induction_drive import InductionDrive
from torquerig.rig.parts.speed_controller import SpeedController
from torquerig.rig.rig import Rig
from torquerig.rig.terms import BladeTorque, Friction, Load, Spring, Term


class _Place(NamedTuple):
    """A node seen from the motor: turns per turn of the motor, and the share of power that arrives there."""

    ratio: float
    efficiency: float


def steady_torque(rig: Rig, motor: str) -> float:
    """Return the mean torque of the motor part ``motor`` at the set-point of the run [N m].

    Every load and friction at its node's mean speed, over the efficiencies of the gears on the way. Ripple, inertia
    and what a random load does around its mean are left out. Zero where the run states no speed.
    """
    terms = _passive(rig)
    places = _places(rig.node(motor), [term for term in terms if isinstance(term, Spring)])
    return _asked(terms, places, rig.run.speed or 0.0)


def steady_torque_in(rig: Rig, spring: str, *, motor: str) -> float:
    """Return the mean torque that the gear or coupling ``spring`` hands on to its output at the set-point [N m].

    What stands behind it, seen from ``motor``; the same things are left out as in :func:`steady_torque`.
    """
    terms = _passive(rig)
    springs = [term for term in terms if isinstance(term, Spring)]
    crossed = next(term for term in springs if term.name == spring)
    from_motor = _places(rig.node(motor), springs)
    if crossed.b not in from_motor:
        return 0.0
    behind = _places(crossed.b, [term for term in springs if term.name != spring])
    return _asked(terms, behind, (rig.run.speed or 0.0) * from_motor[crossed.b].ratio)


def _passive(rig: Rig) -> list[Term]:
    """Return the terms of all but the drives, which ask for the ripple, which may ask for the steady torque."""
    drives = SpeedController | InductionDrive
    return [term for part in rig.parts if not isinstance(part, drives) for term in part.terms(rig)]


def _asked(terms: list[Term], places: dict[str, _Place], speed: float) -> float:
    """Return the torque that loads and frictions on these places ask of the place that turns at ``speed`` [rad/s]."""
    total = 0.0
    for term in terms:
        if isinstance(term, Load | BladeTorque | Friction) and term.on in places:
            place = places[term.on]
            total += _opposing(term, speed * place.ratio) * place.ratio / place.efficiency
    return total


def _places(start: str, springs: list[Spring]) -> dict[str, _Place]:
    places, waiting = {start: _Place(1.0, 1.0)}, [start]
    while waiting:
        here = waiting.pop()
        for spring in springs:
            for near, far, turns in ((spring.a, spring.b, 1 / spring.ratio), (spring.b, spring.a, spring.ratio)):
                if near == here and far not in places:
                    place = places[here]
                    places[far] = _Place(place.ratio * turns, place.efficiency * spring.efficiency)
                    waiting.append(far)
    return places


def _opposing(term: Term, speed: float) -> float:
    """Return the mean torque that opposes the node at ``speed`` [rad/s], positive forwards."""
    if isinstance(term, Load):
        return term.process.mean * tanh(speed / term.smoothing)
    if isinstance(term, BladeTorque):
        return 0.25 * term.amplitude * tanh(speed / term.smoothing)
    if not isinstance(term, Friction):
        return 0.0
    coulomb, static = (
        (term.coulomb_forward, term.static_forward) if speed > 0 else (term.coulomb_backward, term.static_backward)
    )
    grip = coulomb + (static - coulomb) * exp(-((speed / term.stribeck) ** 2))
    return grip * tanh(speed / term.smoothing) + term.viscous * speed + term.quadratic * speed * abs(speed)
