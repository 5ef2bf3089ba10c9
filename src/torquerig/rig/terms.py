"""The closed vocabulary of physics: every part and every mechanism is a sum of these terms, and nothing else.

Each torque acts between two nodes, equal and opposite; ``GROUND`` is the frame. A node is a place on a shaft with one
angle; a term names nodes by the parts that open them. A new term is a reasoned change here, in ``simulate/arrays.py``,
``simulate/lower.py``, ``simulate/kernel.py`` and ``simulate/linear.py``; everything else comes for free.

Sign convention: positive torque on a node speeds it up in the positive direction; the torque of a spring is positive
when ``a`` runs ahead of ``b``, which is how a driving motor loads the sensor.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

GROUND = "ground"


@dataclass(frozen=True, kw_only=True)
class Inertia:
    """``J d(omega)/dt``: inertia [kg m^2] that sits on ``node``; several add up."""

    node: str
    inertia: float


@dataclass(frozen=True, kw_only=True)
class Wave:
    """``amplitude cos(order theta + phase)`` of a node's angle; phase None is drawn from the seed of the run.

    Waves of one term with the same ``phase_key`` share their drawn phase (the side lines of a modulated line).
    """

    order: float
    amplitude: float
    phase: float | None = None
    phase_key: str = ""


@dataclass(frozen=True, kw_only=True)
class Spring:
    """A spring and damper with gap, gear ratio, losses and kinematic error between two shafts.

    ``twist = theta_a / ratio - theta_b + e(theta_b)``; ``T = k twist + c d(twist)/dt``. With a gap, k counts the twist
    beyond it, the damping torque is at most the spring's and the sum never pulls (the contact law of the Modelica
    Standard Library's ElastoBacklash: no jump when the flanks meet). ``b`` gets ``T``, ``a`` gets ``-T / (ratio eta)``
    while power flows from a to b and ``-T eta / ratio`` when it flows back.

    Parameters
    ----------
    name : str
        The part that owns it; a reading names the spring by it.
    a, b : str
        Nodes; ``a`` turns ``ratio`` times as fast.
    stiffness : float
        On the side of b [N m/rad].
    damping : float
        On the side of b [N m s/rad].
    gap : float
        Full gap [rad] on the side of b.
    ratio : float
        Turns of a per turn of b [1]; may be negative for a reversing stage.
    efficiency : float
        Share of the power that arrives [1].
    error : tuple of Wave
        Kinematic (transmission) error e [rad] on the side of b, a function of the angle of b.
    """

    name: str
    a: str
    b: str
    stiffness: float
    damping: float
    gap: float = 0.0
    ratio: float = 1.0
    efficiency: float = 1.0
    error: tuple[Wave, ...] = ()


@dataclass(frozen=True, kw_only=True)
class HarmonicTorque:
    """A torque [N m] that is periodic in the angle of the node ``angle``: lines at that shaft's orders."""

    name: str
    on: str
    angle: str
    waves: tuple[Wave, ...]
    against: str = GROUND


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


class LoadProcess(Protocol):
    """A random torque over time; the simulator asks it for samples."""

    @property
    def mean(self) -> float:
        """What it is on average [N m]."""
        ...

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        """Return ``count`` samples [N m] at ``rate`` [Hz], shape (count,)."""
        ...


@dataclass(frozen=True, kw_only=True)
class Load:
    """A torque that opposes the motion of a node: ``process(t) tanh(w / smoothing)`` (smoothing [rad/s])."""

    name: str
    on: str
    process: LoadProcess
    smoothing: float = 0.02


@dataclass(frozen=True, kw_only=True)
class AppliedTorque:
    """A torque from outside, positive speeding ``on`` up: a test input, or a measured torque that is replayed."""

    name: str
    on: str
    process: LoadProcess


@dataclass(frozen=True, kw_only=True)
class BladeTorque:
    """A load pulse per blade: ``amplitude max(0, cos(order theta + phase))^2`` [N m], opposing the motion."""

    name: str
    on: str
    order: float
    amplitude: float
    phase: float | None = None
    smoothing: float = 0.02


@dataclass(frozen=True, kw_only=True)
class Drive:
    """A speed-controlled motor torque: sampled PI, torque limit, first-order current loop, ripple in proportion.

    ``command = clip(kp (reference - w) + ki integral, +-limit)``, the integrator holds while limited;
    ``torque' = (command - torque) / lag``; the rotor gets ``torque (1 + sum of ripple waves)``.
    ``reference`` is the set-point of the run on this node.
    """

    name: str
    on: str
    kp: float
    ki: float
    torque_limit: float
    lag: float
    against: str = GROUND
    ripple: tuple[Wave, ...] = ()


Term = Inertia | Spring | HarmonicTorque | Friction | Load | AppliedTorque | BladeTorque | Drive
