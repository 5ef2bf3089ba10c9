"""What drives a rig: the motor's torque, torques periodic in an angle, torques from outside."""

from __future__ import annotations

from dataclasses import dataclass, field

from torquerig.rig.terms.inputs import LoadProcess, Signal
from torquerig.rig.terms.shafts import GROUND, Wave
from torquerig.rig.terms.term import ShaftMotion, Term


@dataclass(frozen=True, kw_only=True)
class HarmonicTorque(Term):
    """A torque [N m] that is periodic in the angle of the node ``angle``: lines at that shaft's orders."""

    name: str
    on: str
    angle: str
    waves: tuple[Wave, ...]
    against: str = GROUND

    @property
    def nodes(self) -> tuple[str, ...]:
        """The pair that it acts between, and the node whose angle it follows."""
        return self.on, self.against, self.angle


@dataclass(frozen=True, kw_only=True)
class AppliedTorque(Term):
    """A torque from outside, positive speeding ``on`` up: a test input, or a measured torque that is replayed."""

    name: str
    on: str
    process: LoadProcess | Signal

    @property
    def nodes(self) -> tuple[str, ...]:
        """What it turns."""
        return (self.on,)

    def needed_torque(self, node: str, motion: ShaftMotion) -> float:
        """Return the mean, which helps [N m]; none of a replayed torque, whose mean nobody states."""
        return 0.0 if node != self.on or isinstance(self.process, Signal) else -self.process.mean


@dataclass(frozen=True, kw_only=True)
class Sensing:
    """How a speed loop sees its speed: once a sample, from the measured angle.

    ``angle = floor((theta + sum of error waves) counts / 2 pi) 2 pi / counts``; the difference of two samples times the
    rate goes through ``seen' = (difference - seen) / filter_time``. Nothing stated is the true speed. Without a filter
    one count is ``2 pi rate / counts``, 9.6 rad/s at 16384 counts and 25 kHz.

    Source: the definition of an incremental encoder; error and its effect in signatures.md 2.5. A period counter (time
    between edges) is not in here.

    Parameters
    ----------
    counts : int
        Per turn, after edge multiplication; 0: continuous.
    error : tuple of Wave
        Angle error [rad] at the orders of the shaft itself.
    filter_time : float
        Of the first-order speed filter [s]; 0: none.
    """

    counts: int = 0
    error: tuple[Wave, ...] = ()
    filter_time: float = 0.0

    @property
    def ideal(self) -> bool:
        """Whether the loop sees the true speed."""
        return not (self.counts or self.filter_time or any(wave.amplitude for wave in self.error))


@dataclass(frozen=True, kw_only=True)
class Drive(Term):
    """A motor torque: sampled PI on the speed and a demand beside it, limit, current loop, ripple in proportion.

    ``command = clip(demand + kp (reference - w) + ki integral, +-limit)``, the integrator holds while limited;
    ``torque' = (command - torque) / lag``; the rotor gets ``torque (1 + sum of ripple waves)``. ``reference`` is the
    speed set-point of the run on this node. With kp and ki zero it is a drive in torque mode.

    Parameters
    ----------
    torque : float
        Demand [N m] that follows the profile of the run as the speed does: 10 % at the start of a ramp.
    demand : Signal or None
        A further demand [N m] at every sample: a measured motor torque that is replayed, or fed forward.
    breakdown : float
        Slip speed [rad/s] at which an induction machine on its supply breaks down; 0 is a controlled drive. Above 0 the
        command is ``2 limit x / (1 + x^2)``, ``x = (reference - w) / breakdown`` (Kloss), in place of PI and clip;
        ``kp`` is then the slope without load, ``2 limit / breakdown``, and ki zero.
    sensing : Sensing
        How the speed loop sees w.
    """

    name: str
    on: str
    kp: float
    ki: float
    torque_limit: float
    lag: float
    against: str = GROUND
    ripple: tuple[Wave, ...] = ()
    torque: float = 0.0
    demand: Signal | None = None
    breakdown: float = 0.0
    sensing: Sensing = field(default_factory=Sensing)

    @property
    def nodes(self) -> tuple[str, ...]:
        """The pair that it acts between."""
        return self.on, self.against

    @property
    def holds_speed(self) -> bool:
        """Whether it controls the speed (and not the torque alone)."""
        return self.kp > 0 or self.ki > 0
