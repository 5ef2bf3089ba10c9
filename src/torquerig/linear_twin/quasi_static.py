"""What a rig asks of sensor and motor while nothing vibrates: loads, friction, acceleration, along the shafts."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.linear_twin.twin import BLADE_MEAN, Twin
from torquerig.rig.terms import BladeTorque, Friction, Inertia, Load

Floats = NDArray[np.float64]

OPPOSING = (Inertia, Friction, Load, BladeTorque)  # what asks for a slow torque


@dataclass(frozen=True)
class QuasiStatic:
    """Torque at the sensor and at the motor [N m], shapes as the speeds asked for."""

    sensor: Floats
    motor: Floats


def quasi_static(
    twin: Twin, *, speed: Floats, acceleration: Floats, held: Mapping[str, Floats] | None = None
) -> QuasiStatic:
    """Return the torques while the motor turns at ``speed`` [rad/s] and gains ``acceleration`` [rad/s^2].

    Power balance along the shafts: each torque reaches motor and sensor times the turns of its node, over theirs and
    over the efficiencies between; the sensor reads it negative where it turns against the motor. Springs are taken as
    rigid, which holds far below the first mode. ``held`` is the share of its dry torque, from -1 to 1, that a node
    holds, shape as ``speed``; without it that of the direction of its speed.
    """
    sensor, motor = np.zeros(speed.shape), np.zeros(speed.shape)
    behind, efficiency = shares_at_sensor(twin), _efficiency(twin)
    for term in twin.terms:
        if not isinstance(term, OPPOSING):
            continue
        node = term.node if isinstance(term, Inertia) else term.on
        if node not in twin.turns:
            continue
        share = None if held is None else held.get(node)
        torque = _opposing(term, speed * twin.turns[node], acceleration * twin.turns[node], share)
        motor += torque * twin.turns[node] / efficiency.get(node, 1.0)
        if node in behind:
            sensor += behind[node] * torque
    return QuasiStatic(sensor, motor)


def _opposing(term: object, speed: Floats, acceleration: Floats, held: Floats | None) -> Floats:
    if isinstance(term, Inertia):
        return yielding_torque(term, speed, acceleration)
    if held is not None:
        return np.asarray(yielding_torque(term, speed, acceleration) + np.abs(dry_torque(term, speed)) * held)
    smoothing = getattr(term, "smoothing", 1.0)
    return np.asarray(
        yielding_torque(term, speed, acceleration) + dry_torque(term, speed) * np.abs(np.tanh(speed / smoothing))
    )


def yielding_torque(term: object, speed: Floats, acceleration: Floats) -> Floats:
    """Return what a term asks for without holding [N m]: inertia, viscous and quadratic drag, what pushes one way."""
    if isinstance(term, Inertia):
        return np.asarray(term.inertia * acceleration)
    if isinstance(term, Friction):
        return np.asarray(term.viscous * speed + term.quadratic * speed * np.abs(speed))
    if isinstance(term, BladeTorque) and term.one_way:
        return np.full(speed.shape, BLADE_MEAN * term.amplitude)
    return np.zeros(speed.shape)


def dry_torque(term: object, speed: Floats) -> Floats:
    """Return what a term holds against sliding at ``speed`` [rad/s], in its direction [N m]."""
    way = np.where(speed < 0, -1.0, 1.0)
    if isinstance(term, Load):
        return np.asarray(term.process.mean * way)
    if isinstance(term, BladeTorque) and not term.one_way:
        return np.asarray(BLADE_MEAN * term.amplitude * way)
    if isinstance(term, Friction):
        coulomb = np.where(speed > 0, term.coulomb_forward, term.coulomb_backward)
        static = np.where(speed > 0, term.static_forward, term.static_backward)
        peak = (static - coulomb) * np.exp(-np.minimum((speed / term.stribeck) ** 2, 50.0))
        return np.asarray(way * (coulomb + peak))
    return np.zeros(speed.shape)


def shares_at_sensor(twin: Twin) -> dict[str, float]:
    """Return what the sensor reads of a torque that opposes the motion of each node behind it.

    As its node turns for a turn of the sensor, over the efficiencies between; negative where the sensor turns against
    the motor.
    """
    read, efficiency = twin.springs[twin.rig.measured].b, _efficiency(twin)
    way = twin.scale if twin.forward else -twin.scale
    return {
        node: way * twin.turns[node] / twin.turns[read] * efficiency[read] / efficiency[node]
        for node in behind_sensor(twin) & twin.turns.keys()
    }


def behind_sensor(twin: Twin) -> set[str]:
    """Return the nodes whose torque passes the sensor: reached from its output side without going back through it."""
    start = twin.springs[twin.rig.measured].b
    seen, waiting = {start}, deque([start])
    while waiting:
        here = waiting.popleft()
        for spring in twin.springs.values():
            if spring.name == twin.rig.measured:
                continue
            for near, far in ((spring.a, spring.b), (spring.b, spring.a)):
                if near == here and far not in seen:
                    seen.add(far)
                    waiting.append(far)
    return seen


def _efficiency(twin: Twin) -> dict[str, float]:
    """Product of the efficiencies between the motor and each node."""
    start = twin.drives[0].on
    found, waiting = {start: 1.0}, deque([start])
    while waiting:
        here = waiting.popleft()
        for spring in twin.springs.values():
            for near, far in ((spring.a, spring.b), (spring.b, spring.a)):
                if near == here and far not in found:
                    found[far] = found[here] * spring.efficiency
                    waiting.append(far)
    return found
