"""How much of its dry torque a shaft holds while the springs before it wind the other way after a reversal.

Dry friction and a load that opposes motion hold a shaft until the springs between motor and shaft carry the torque T.
With the compliance c of these springs the motor turns on by 2 c T after it has turned back. The torque is smoothed over
the speed s of the shaft, ``T tanh(w / s)``, so the share y held of T obeys ``c T dy/dt = w_m - s artanh(y)``, w_m the
speed of the motor on the side of the shaft. For s = 0 that is Prandtl's elastic-plastic element (Visintin 1994,
Differential Models of Hysteresis, III). Far below the first mode; a gap is not in it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.level_motion import POINTS
from torquerig.inference.features.run_features import RunFeatures
from torquerig.linear_twin.kernel import smoothed_share
from torquerig.linear_twin.quasi_static import OPPOSING, dry_torque
from torquerig.linear_twin.twin import Twin
from torquerig.rig.terms import Inertia

Floats = NDArray[np.float64]

_MOMENTS = 6000  # of a run at which the operator is followed
_SLOWEST = 1e-9  # [rad/s] at which a shaft starts to slide


def held_shares(twin: Twin, seen: RunFeatures) -> Mapping[str, Floats] | None:
    """Return by node the share of its dry torque that it holds at the moments of each part, shape (levels, POINTS).

    None where the motor does not turn both ways: then it is that of the direction.
    """
    if not seen.level_speed.size or not seen.level_speed.min() < 0 < seen.level_speed.max():
        return None
    return {
        each.node: seen.kept.get(f"held by {each.node}", each, partial(_at_moments, seen, each)) for each in _held(twin)
    }


@dataclass(frozen=True)
class _Held:
    """A node with dry torque: its turns, by how much the springs before it wind up [rad], and its smoothing [rad/s]."""

    node: str
    turns: float
    wound: float
    smoothing: float


def _held(twin: Twin) -> Iterator[_Held]:
    """Yield the nodes with dry torque."""
    dry = [term for term in twin.terms if isinstance(term, OPPOSING) and not isinstance(term, Inertia)]
    for node in dict.fromkeys(term.on for term in dry):
        sizes = {term: float(np.abs(dry_torque(term, np.array([_SLOWEST])))[0]) for term in dry if term.on == node}
        torque, turns = sum(sizes.values()), twin.turns.get(node, 0.0)
        if turns and torque:
            largest = max(sizes, key=lambda term: sizes[term])
            yield _Held(node, turns, compliance(twin, node) * torque, getattr(largest, "smoothing", 0.0))


def compliance(twin: Twin, node: str) -> float:
    """Return the compliance of the springs between motor and a node, on the side of the node [rad/(N m)]."""
    before = {twin.drives[0].on: 0.0}
    waiting = [twin.drives[0].on]
    while waiting:
        here = waiting.pop()
        for spring in twin.springs.values():
            for near, far in ((spring.a, spring.b), (spring.b, spring.a)):
                if near == here and far not in before and spring.b in twin.turns:
                    before[far] = before[here] + 1 / (spring.stiffness * twin.turns[spring.b] ** 2)
                    waiting.append(far)
    return before.get(node, 0.0) * twin.turns[node] ** 2


def _at_moments(seen: RunFeatures, each: _Held) -> Floats:
    at, angle = seen.run.kept.get("angle at moments", None, lambda: _angle_at_moments(seen))
    turned = each.turns * angle
    slip = each.smoothing * (at[1] - at[0]) / seen.run.rate
    held = share_held(turned, each.wound, slip)
    share = np.linspace(0.0, 1.0, POINTS)
    moments = seen.parts[:, :1] + share * (seen.parts[:, 1:] - 1 - seen.parts[:, :1])
    return np.asarray(np.interp(moments, at, held))


def _angle_at_moments(seen: RunFeatures) -> tuple[Floats, Floats]:
    """Return the samples at which the operator is followed, and the angle of the motor there [rad]."""
    angle = seen.run.angle
    at = np.linspace(0, angle.size - 1, min(_MOMENTS, angle.size))
    return at, np.asarray(np.interp(at, np.arange(angle.size), angle))


def share_held(angle: Floats, wound: float, slip: float) -> Floats:
    """Return the share held, from -1 to 1, along an angle of the motor on the side of the shaft [rad].

    ``wound`` is the angle by which the full torque winds the springs up, ``slip`` what the shaft turns in a step at the
    speed of its smoothing [rad]. Implicit Euler steps: ``y + (slip / wound) artanh(y) = y_before + step / wound``.
    """
    least = max(wound, 1e-12)
    steps, softness = np.diff(angle) / least, max(slip / least, 1e-9)
    here = float(np.tanh(steps[0] / softness)) if steps.size else 0.0
    return np.concatenate([[here], smoothed_share(steps, softness, here)])
