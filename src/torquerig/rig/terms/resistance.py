"""What opposes motion: friction and loads."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp

from torquerig.rig.terms.inputs import AngleProcess, LoadProcess
from torquerig.rig.terms.shafts import GROUND
from torquerig.rig.terms.term import ShaftMotion, Term

BLADE_MEAN = 0.25  # mean of max(0, cos)^2 over a turn


@dataclass(frozen=True, kw_only=True)
class Friction(Term):
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

    @property
    def nodes(self) -> tuple[str, ...]:
        """The pair that it acts between."""
        return self.on, self.against

    def needed_torque(self, node: str, motion: ShaftMotion) -> float:
        """Return what overcomes it against the frame [N m]; friction between two shafts is left out."""
        return self._steady(motion) if node == self.on and self.against == GROUND else 0.0

    def _steady(self, motion: ShaftMotion) -> float:
        torque = _sliding(self, motion)
        if self.viscous_backward is not None and motion.speed < 0:
            torque += (self.viscous_backward - self.viscous) * motion.speed
        return torque + self.quadratic * motion.speed * abs(motion.speed)


@dataclass(frozen=True, kw_only=True)
class BristleFriction(Term):
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

    @property
    def nodes(self) -> tuple[str, ...]:
        """The pair that it acts between."""
        return self.on, self.against

    def needed_torque(self, node: str, motion: ShaftMotion) -> float:
        """Return what overcomes it against the frame [N m]; friction between two shafts is left out."""
        return _sliding(self, motion) if node == self.on and self.against == GROUND else 0.0


@dataclass(frozen=True, kw_only=True)
class AngleLoad(Term):
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

    @property
    def nodes(self) -> tuple[str, ...]:
        """What it opposes."""
        return (self.on,)

    def needed_torque(self, node: str, motion: ShaftMotion) -> float:
        """Return what overcomes its mean [N m]."""
        return motion.way * self.process.mean if node == self.on else 0.0


@dataclass(frozen=True, kw_only=True)
class Load(Term):
    """A torque that opposes the motion of a node: ``process(t) tanh(w / smoothing)`` (smoothing [rad/s])."""

    name: str
    on: str
    process: LoadProcess
    smoothing: float = 0.02

    @property
    def nodes(self) -> tuple[str, ...]:
        """What it opposes."""
        return (self.on,)

    def needed_torque(self, node: str, motion: ShaftMotion) -> float:
        """Return what overcomes its mean [N m]."""
        return motion.way * self.process.mean * motion.load_share if node == self.on else 0.0


@dataclass(frozen=True, kw_only=True)
class BladeTorque(Term):
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

    @property
    def nodes(self) -> tuple[str, ...]:
        """What it opposes."""
        return (self.on,)

    def needed_torque(self, node: str, motion: ShaftMotion) -> float:
        """Return what overcomes its mean [N m]."""
        return (1.0 if self.one_way else motion.way) * BLADE_MEAN * self.amplitude if node == self.on else 0.0


def _sliding(one: Friction | BristleFriction, motion: ShaftMotion) -> float:
    """Return the torque of dry and viscous friction that slides [N m]."""
    forwards = motion.way > 0
    dry = one.coulomb_forward if forwards else one.coulomb_backward
    static = one.static_forward if forwards else one.static_backward
    dry += motion.peak * (static - dry) * exp(-((motion.speed / one.stribeck) ** 2))
    return motion.way * dry + one.viscous * motion.speed
