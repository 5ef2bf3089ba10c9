"""What a rig asks of sensor and motor while nothing vibrates: loads, friction, acceleration, along the shafts."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from math import exp, tanh

from torquerig.diagnose.twin import BLADE_MEAN, Twin
from torquerig.rig.terms import BladeTorque, Friction, Inertia, Load


@dataclass(frozen=True)
class QuasiStatic:
    """Torque at the sensor and at the motor [N m], and the mean of the random load in the former."""

    sensor: float
    motor: float


def quasi_static(twin: Twin, *, speed: float, acceleration: float) -> QuasiStatic:
    """Return the torques while the motor turns at ``speed`` [rad/s] and gains ``acceleration`` [rad/s^2].

    Power balance along the shafts: each torque reaches the motor times the turns of its node and over the efficiencies
    between. Springs are taken as rigid, which holds far below the first mode.
    """
    sensor = motor = 0.0
    behind, efficiency = _behind_sensor(twin), _efficiency(twin)
    for term in twin.terms:
        node = getattr(term, "on", getattr(term, "node", None))
        if node is None or node not in twin.turns:
            continue
        torque = _opposing(term, speed * twin.turns[node], acceleration * twin.turns[node])
        motor += torque * twin.turns[node] / efficiency.get(node, 1.0)
        if node in behind:
            sensor += torque
    return QuasiStatic(sensor, motor)


def _opposing(term: object, speed: float, acceleration: float) -> float:
    if isinstance(term, Inertia):
        return term.inertia * acceleration
    if isinstance(term, Load):
        return term.process.mean * tanh(speed / term.smoothing)
    if isinstance(term, BladeTorque):
        return BLADE_MEAN * term.amplitude * tanh(speed / term.smoothing)
    if isinstance(term, Friction):
        coulomb = term.coulomb_forward if speed > 0 else term.coulomb_backward
        static = term.static_forward if speed > 0 else term.static_backward
        grip = coulomb + (static - coulomb) * exp(-min((speed / term.stribeck) ** 2, 50.0))
        return grip * tanh(speed / term.smoothing) + term.viscous * speed + term.quadratic * speed * abs(speed)
    return 0.0


def _behind_sensor(twin: Twin) -> set[str]:
    """Nodes whose torque passes the sensor: reached from its output side without going back through it."""
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
