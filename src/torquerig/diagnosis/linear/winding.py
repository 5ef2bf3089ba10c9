"""Torque near standstill: dry loads hold until the shafts are wound up far enough to drag them along."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.linear.kernel import elastic_plastic
from torquerig.linear_twin.quasi_static import dry_torque, shares_at_sensor, yielding_torque
from torquerig.linear_twin.twin import Twin

Floats = NDArray[np.float64]

_PRESLIDING = 0.6  # of the stiffness is left where the contact itself bends before it slides [1]


@dataclass(frozen=True)
class Wound:
    """Torque of the sensor at each step of a course [N m], and what bending contacts may change of it [N m]."""

    torque: Floats
    tolerance: Floats


def wound_torque(twin: Twin, *, speed: Floats, acceleration: Floats, step: float, start: float) -> Wound:
    """Return the sensor's torque while the motor goes through a course of speeds [rad/s], ``step`` [s] apart.

    Each node with dry torques is an elastic, perfectly plastic element (Prandtl): its torque grows by ``k`` times the
    angle that the motor turns on, k being the stiffness of the shafts between, until it reaches what the dry torques
    can hold at that speed and direction; then it slides. Inertia and viscous torques are as in ``quasi_static``. Far
    below the first mode. Masing 1926 for the hysteresis of such elements. ``start`` is the torque [N m] at the first
    step, which no model knows.
    """
    torque, soft = np.zeros(speed.size), np.zeros(speed.size)
    for node, share in sorted(shares_at_sensor(twin).items()):
        terms = [t for t in twin.terms if node == getattr(t, "on", getattr(t, "node", None))]
        turned, gained = speed * twin.turns[node], acceleration * twin.turns[node]
        own = sum((yielding_torque(term, turned, gained) for term in terms), np.zeros(speed.size))
        torque, soft = torque + share * own, soft + share * own
        forward = sum((dry_torque(term, np.abs(turned)) for term in terms), np.zeros(speed.size))
        backward = sum((-dry_torque(term, -np.abs(turned)) for term in terms), np.zeros(speed.size))
        if not (forward.any() or backward.any()):
            continue
        stiffness, twist = 1 / compliance(twin, node), turned * step
        at_first = start / share
        torque = torque + share * elastic_plastic(twist, stiffness, forward, backward, at_first)
        soft = soft + share * elastic_plastic(twist, _PRESLIDING * stiffness, forward, backward, at_first)
    return Wound(0.5 * (torque + soft), 0.5 * np.abs(torque - soft))


def compliance(twin: Twin, node: str) -> float:
    """Return by what angle ``node`` gives way to a torque on it [rad/(N m)], the motor held; 0 where rigid."""
    here, found = twin.drives[0].on, {twin.drives[0].on: 0.0}
    waiting = deque([here])
    while waiting:
        here = waiting.popleft()
        for spring in twin.springs.values():
            for near, far in ((spring.a, spring.b), (spring.b, spring.a)):
                if near == here and far not in found:
                    found[far] = found[here] + twin.turns[spring.b] ** -2 / spring.stiffness
                    waiting.append(far)
    return found.get(node, 0.0) * twin.turns[node] ** 2
