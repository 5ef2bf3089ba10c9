"""All that a motor drives, seen from its shaft: inertia, load and friction through the gears."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from math import copysign
from typing import NamedTuple

from torquerig.rig.parts import InductionDrive, Motor, SpeedController
from torquerig.rig.rig import Rig
from torquerig.rig.terms import GROUND, AppliedTorque, BladeTorque, Friction, Inertia, Load, Signal, Spring, Term

BLADE_MEAN = 0.25  # mean of max(0, cos)^2 over a turn


class _Motion(NamedTuple):
    """Of a node: speed [rad/s], acceleration [rad/s^2], direction (1, 0, -1)."""

    speed: float
    acceleration: float
    way: float


@dataclass(frozen=True, kw_only=True)
class DriveTrain:
    """A rig with stiff shafts as its motor feels it.

    Parameters
    ----------
    terms : tuple of Term
        The rig's physics.
    ratios : dict of str to float
        Turns of each node per motor turn [1]; nodes that no shaft leads to are left out.
    efficiencies : dict of str to float
        Share of the motor's power that arrives at each node [1].
    """

    terms: tuple[Term, ...]
    ratios: dict[str, float]
    efficiencies: dict[str, float]

    @property
    def inertia(self) -> float:
        """All inertia at the motor, ``sum of J r^2`` [kg m^2]."""
        return sum(one.inertia * self.ratios.get(one.node, 0.0) ** 2 for one in self.terms if isinstance(one, Inertia))

    @property
    def mean_load(self) -> float:
        """The mean of the loads at their own shafts [N m]."""
        return sum(one.process.mean for one in self.terms if isinstance(one, Load))

    def torque(self, speed: float, acceleration: float, *, load: float | None = None, way: float = 1.0) -> float:
        """Return the motor torque [N m] at a motor speed [rad/s] and its acceleration [rad/s^2].

        Gears lose power in the direction in which it flows: what is driven counts divided by its efficiency, what
        drives back times it. ``way`` (1, 0 or -1) is the direction of motion for dry friction and loads, which hold
        nothing at rest. ``load`` [N m] is the mean of all loads, where it is not the rig's own.

        Left out: friction between two shafts, Stribeck's peak (Coulomb friction counts), ripple, replayed
        torques, bristles.
        """
        share = 1.0 if load is None or self.mean_load == 0 else load / self.mean_load
        by_efficiency: dict[float, float] = {}
        for node, ratio in self.ratios.items():
            motion = _Motion(speed * ratio, acceleration * ratio, copysign(1.0, ratio) * way)
            needed = sum(_needed(one, motion, share) for one in self.terms if _acts_on(one) == node)
            efficiency = self.efficiencies[node]
            by_efficiency[efficiency] = by_efficiency.get(efficiency, 0.0) + needed * ratio
        heading = way or copysign(1.0, acceleration)
        return sum(
            torque / efficiency if torque * heading >= 0 else torque * efficiency
            for efficiency, torque in by_efficiency.items()
        )


def driven_motor(rig: Rig) -> Motor | None:
    """Return the motor that follows the run's set-point, under a controller or on an inverter; None without one."""
    drives: tuple[SpeedController | InductionDrive, ...]
    drives = (*rig.parts_of(SpeedController), *rig.parts_of(InductionDrive))
    part = rig.part(drives[0].motor) if drives else None
    return part if isinstance(part, Motor) else None


def drive_train(rig: Rig, motor: str) -> DriveTrain:
    """Return what the node ``motor`` of the rig drives, at the rig's operating point."""
    terms = rig.terms()
    return DriveTrain(terms=terms, ratios=rig.speed_ratios(motor), efficiencies=_efficiencies(terms, motor))


def _efficiencies(terms: Sequence[Term], motor: str) -> dict[str, float]:
    springs = [term for term in terms if isinstance(term, Spring)]
    found, waiting = {motor: 1.0}, deque([motor])
    while waiting:
        here = waiting.popleft()
        for spring in springs:
            for start, end in ((spring.a, spring.b), (spring.b, spring.a)):
                if start == here and end not in found:
                    found[end] = found[here] * spring.efficiency
                    waiting.append(end)
    return found


def _acts_on(one: Term) -> str | None:
    if isinstance(one, Inertia):
        return one.node
    return one.on if isinstance(one, Friction | Load | BladeTorque | AppliedTorque) else None


def _needed(one: Term, motion: _Motion, share: float) -> float:
    """Return the torque [N m] in its node's positive direction that one term needs."""
    speed, way = motion.speed, motion.way
    if isinstance(one, Inertia):
        return one.inertia * motion.acceleration
    if isinstance(one, Friction) and one.against == GROUND:
        dry = one.coulomb_forward if way > 0 else one.coulomb_backward
        return way * dry + one.viscous * speed + one.quadratic * speed * abs(speed)
    if isinstance(one, Load):
        return way * share * one.process.mean
    if isinstance(one, BladeTorque):
        return way * BLADE_MEAN * one.amplitude
    if isinstance(one, AppliedTorque) and not isinstance(one.process, Signal):
        return -one.process.mean
    return 0.0
