"""What drives a rig: the motor's torque, torques periodic in an angle, torques from outside."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.rig.terms.inputs import LoadProcess, Signal
from torquerig.rig.terms.shafts import GROUND, Wave


@dataclass(frozen=True, kw_only=True)
class HarmonicTorque:
    """A torque [N m] that is periodic in the angle of the node ``angle``: lines at that shaft's orders."""

    name: str
    on: str
    angle: str
    waves: tuple[Wave, ...]
    against: str = GROUND


@dataclass(frozen=True, kw_only=True)
class AppliedTorque:
    """A torque from outside, positive speeding ``on`` up: a test input, or a measured torque that is replayed."""

    name: str
    on: str
    process: LoadProcess | Signal


@dataclass(frozen=True, kw_only=True)
class Drive:
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

    @property
    def holds_speed(self) -> bool:
        """Whether it controls the speed (and not the torque alone)."""
        return self.kp > 0 or self.ki > 0
