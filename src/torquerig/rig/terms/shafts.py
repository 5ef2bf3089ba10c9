"""What shafts are made of: inertias, the springs between them, and motions that are imposed on them."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.rig.terms.inputs import Motion
from torquerig.rig.terms.term import ShaftMotion, Term

GROUND = "ground"


@dataclass(frozen=True, kw_only=True)
class Inertia(Term):
    """``J d(omega)/dt``: inertia [kg m^2] that sits on ``node``; several add up."""

    node: str
    inertia: float

    @property
    def nodes(self) -> tuple[str, ...]:
        """Where it sits."""
        return (self.node,)

    def needed_torque(self, node: str, motion: ShaftMotion) -> float:
        """Return what accelerates it [N m]."""
        return self.inertia * motion.acceleration if node == self.node else 0.0


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
class Spring(Term):
    """A spring and damper with gap, gear ratio, losses, kinematic error and varying stiffness between two shafts.

    ``twist = theta_a / ratio - theta_b - rest + e(theta_b)``; ``T = k(theta_b) twist + c d(twist)/dt``. With a gap, k
    counts the twist beyond it, the damping torque is at most the spring's and the sum never pulls (the contact law of
    the Modelica Standard Library's ElastoBacklash: no jump when the flanks meet). ``b`` gets ``T (1 - e') - k' twist^2
    / 2``, ``a`` gets ``-T / (ratio eta)`` while power flows from a to b and ``-T eta_b / ratio`` when it flows back.

    The power that enters at a, ``T omega_a / ratio``, gives the direction (the rule of the Library's LossyGear). So
    the loss ``abs(T omega_a / ratio) (1/eta - 1 or 1 - eta_b) tanh(abs(omega_a / ratio) / smoothing)`` is never below
    0, and a gear at standstill loses nothing. Not true at standstill, where flanks hold by static friction.

    The primed terms (derivatives by theta_b) follow from the energy ``k(theta_b) twist^2 / 2`` that spring and shafts
    share: an error or a stiffness that turns with the shaft does no work of its own, the housing bears the difference.

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
    rest : float
        ``theta_a / ratio - theta_b`` without torque [rad]: the zero of the spring, or the middle of its gap. It counts
        where both sides are held, imposed, or linked by a second path; a free chain settles to it.
    ratio : float
        Turns of a per turn of b [1]; may be negative for a reversing stage.
    efficiency : float
        Share of the power that arrives [1].
    backward_efficiency : float or None
        The same where power flows from b to a; None where it is equal. At 0 or less b cannot drive a.
    smoothing : float
        ``omega_a / ratio`` [rad/s] over which the direction of the flow of power turns, where there are losses.
    error : tuple of Wave
        Kinematic (transmission) error e [rad] on the side of b, a function of the angle of b.
    stiffness_waves : tuple of Wave
        ``k = stiffness (1 + sum of waves)``, a function of the angle of b [1]; the amplitudes' sum is below 1.
    damping_follows : bool
        Whether c varies with k, or stays.
    """

    name: str
    a: str
    b: str
    stiffness: float
    damping: float
    gap: float = 0.0
    rest: float = 0.0
    ratio: float = 1.0
    efficiency: float = 1.0
    backward_efficiency: float | None = None
    smoothing: float = 0.02
    error: tuple[Wave, ...] = ()
    stiffness_waves: tuple[Wave, ...] = ()
    damping_follows: bool = False

    @property
    def backwards(self) -> float:
        """Share of the power that arrives where it flows from b to a [1]."""
        return self.efficiency if self.backward_efficiency is None else self.backward_efficiency

    @property
    def nodes(self) -> tuple[str, ...]:
        """Both ends."""
        return self.a, self.b


@dataclass(frozen=True, kw_only=True)
class ImposedMotion(Term):
    """A node whose angle and speed are given at every sample; the rest of the rig reacts.

    Between samples the angle is the cubic Hermite polynomial through both angles and both speeds, so that angle and
    speed have no jump. What the imposing takes, ``J d(omega)/dt - sum of all other torques``, can be recorded. Not true
    above half the sample rate, and for angles in coarse counts unless they were smoothed first.

    Parameters
    ----------
    motion : Motion or None
        None: the set-point of the run.
    factor : float
        Multiplies the set-point of the run [1].
    released : bool
        Imposed only while the rig settles; then the node moves as its torques say.
    """

    name: str
    on: str
    motion: Motion | None = None
    factor: float = 1.0
    released: bool = False

    @property
    def nodes(self) -> tuple[str, ...]:
        """What it moves."""
        return (self.on,)
