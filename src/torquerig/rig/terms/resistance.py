"""What opposes motion: friction and loads."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.rig.terms.inputs import AngleProcess, LoadProcess
from torquerig.rig.terms.shafts import GROUND


@dataclass(frozen=True, kw_only=True)
class Friction:
    """What opposes the relative motion of two nodes: Coulomb, Stribeck, viscous and quadratic, by direction.

    ``T = (Tc + (Ts - Tc) exp(-(w/ws)^2)) tanh(w / smoothing) + viscous w + quadratic w |w|``, w the relative speed
    [rad/s]; Tc, Ts [N m] and viscous [N m s/rad] take the value of the direction of motion; ``viscous_backward``
    is the forward one where None.
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
    viscous_backward: float | None = None
    quadratic: float = 0.0
    smoothing: float = 0.02


@dataclass(frozen=True, kw_only=True)
class BristleFriction:
    """Dry friction that bends before it slides: the LuGre model.

    ``z' = w - s0 |w| z / g(w)``; ``T = s0 z + s1 z' + viscous w``; ``g(w) = Tc + (Ts - Tc) exp(-(w/ws)^2)`` by the
    direction of motion, w the relative speed [rad/s]. At steady speed ``T = sign(w) g(w) + viscous w``, the Stribeck
    curve; before sliding it is a spring s0 with damping s1, with hysteresis.

    Source: Canudas de Wit, Olsson, Astrom & Lischinsky 1995, IEEE Trans. Automatic Control 40(3), eq. 1-4. Where the
    bristle follows faster than an integration step (``s0 |w| / g > 1 / step``, at high speed), it is taken to follow
    within one step. It drifts under a load that oscillates below breakaway, as LuGre does (Dupont, Hayward, Armstrong
    & Altpeter 2002, IEEE Trans. Automatic Control 47(5)).

    Parameters
    ----------
    stiffness, damping : float
        s0 [N m/rad] > 0 and s1 [N m s/rad] of the bristles.
    coulomb_forward, coulomb_backward, static_forward, static_backward : float
        Tc and Ts [N m] > 0.
    """

    name: str
    on: str
    stiffness: float
    damping: float
    coulomb_forward: float
    coulomb_backward: float
    static_forward: float
    static_backward: float
    against: str = GROUND
    stribeck: float = 1.0
    viscous: float = 0.0


@dataclass(frozen=True, kw_only=True)
class AngleLoad:
    """A torque that depends on where a node stands: ``process(theta) tanh(w / smoothing)``, opposing its motion.

    The same trace over the angle whatever the speed, so its energy per turn does not depend on the speed either: the
    drag of a dense granular bed. Between the points of its grid it is linear; behind the last point it starts again.

    Source: Miller, O'Hern & Behringer 1996, Phys. Rev. Lett. 77(15) (stresses of sheared grains).
    Not true where grains fly or stream: hits are a ``Load``.
    """

    name: str
    on: str
    process: AngleProcess
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
    """A load pulse per blade: ``amplitude max(0, cos(order theta + phase))^2`` [N m], opposing the motion.

    ``one_way`` pulses push against forward motion whichever way the shaft turns.
    """

    name: str
    on: str
    order: float
    amplitude: float
    phase: float | None = None
    smoothing: float = 0.02
    one_way: bool = False
