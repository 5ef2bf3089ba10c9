"""What opposes motion: friction and loads."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.rig.terms.inputs import LoadProcess
from torquerig.rig.terms.shafts import GROUND


@dataclass(frozen=True, kw_only=True)
class Friction:
    """What opposes the relative motion of two nodes: Coulomb, Stribeck, viscous and quadratic, by direction.

    ``T = (Tc + (Ts - Tc) exp(-(w/ws)^2)) tanh(w / smoothing) + viscous w + quadratic w |w|``, w the relative speed
    [rad/s]; Tc and Ts [N m] take the value of the direction of motion.
    """

    name: str
    on: str
    against: str = GROUND
    coulomb_forward: float = 0.0
    coulomb_backward: float = 0.0
    static_forward: float = 0.0
    static_backward: float = 0.0
    stribeck: float = 1.0
    viscous: float = 0.0
    quadratic: float = 0.0
    smoothing: float = 0.02


@dataclass(frozen=True, kw_only=True)
class Load:
    """A torque that opposes the motion of a node: ``process(t) tanh(w / smoothing)`` (smoothing [rad/s])."""

    name: str
    on: str
    process: LoadProcess
    smoothing: float = 0.02


@dataclass(frozen=True, kw_only=True)
class BladeTorque:
    """A load pulse per blade: ``amplitude max(0, cos(order theta + phase))^2`` [N m], opposing the motion."""

    name: str
    on: str
    order: float
    amplitude: float
    phase: float | None = None
    smoothing: float = 0.02
