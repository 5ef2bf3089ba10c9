"""The drive train reduced to the motor shaft: inertia, load and friction through the gears."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import copysign
from typing import NamedTuple

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.induction_drive import InductionDrive
from torquerig.rig.parts.motor import Motor
from torquerig.rig.parts.speed_controller import SpeedController
from torquerig.rig.parts.torque_controller import TorqueController
from torquerig.rig.terms import GROUND, Inertia, Load, ShaftMotion, Spring, Term

NO_LOAD: Mapping[str, float] = {}


class Place(NamedTuple):
    """A node seen from the motor: turns per turn of the motor, and the share of power that arrives there.

    ``backwards`` is the share that arrives at the motor where the node drives; 0 or less where it cannot.
    """

    ratio: float
    efficiency: float
    backwards: float


@dataclass(frozen=True, kw_only=True)
class DriveTrain:
    """A rig with stiff shafts, reduced to its motor (or to a given shaft).

    Gears lose power in the direction in which it flows: what is driven counts divided by its efficiency, what drives
    back times it. Left out everywhere: friction between two shafts, ripple, replayed torques, what a random load does
    around its mean, what second motors give (:mod:`~torquerig.scenario.checks.recorded_load` refuses what matters).

    Parameters
    ----------
    terms : tuple of Term
        The rig's physics.
    places : dict of str to Place
        The nodes as that shaft sees them; nodes that no shaft leads to are left out.
    """

    terms: tuple[Term, ...]
    places: dict[str, Place]

    @property
    def inertia(self) -> float:
        """All inertia at the motor, ``sum of J r^2`` [kg m^2]."""
        placed = ((one, self.places.get(one.node)) for one in self.terms if isinstance(one, Inertia))
        return sum(one.inertia * place.ratio**2 for one, place in placed if place)

    @property
    def mean_load(self) -> float:
        """The mean of the loads at their shafts [N m]."""
        return sum(one.process.mean for one in self.terms if isinstance(one, Load))

    def torque(self, speed: float, acceleration: float, *, load: float | None = None, way: float = 1.0) -> float:
        """Return the motor torque [N m] at a motor speed [rad/s] and its acceleration [rad/s^2].

        ``way`` (1, 0 or -1) is the direction of motion for dry friction and loads, which hold nothing at rest.
        ``load`` [N m] is the mean of all loads, where it is not the rig's own; without a load of more than 0 in the rig
        it acts where a load is, else at the far end of the train. Stribeck's peak is left out (Coulomb
        friction counts): a motion that passes through rest has it for a moment only.
        """
        if load is None:
            return self.needed(ShaftMotion(speed, acceleration, way, 0.0, 1.0))
        if self.mean_load == 0:
            further = {self.loaded_node(): load} if load else {}
            return self.needed(ShaftMotion(speed, acceleration, way, 0.0, 1.0), further)
        return self.needed(ShaftMotion(speed, acceleration, way, 0.0, load / self.mean_load))

    def holding_torque(self, load: float) -> float:
        """Return the motor torque [N m] that holds a stated load [N m] at rest, against a positive turn of its place.

        It counts over the efficiency of the gears: this torque also starts the motion against the load. Friction is
        left out, because it helps to hold.
        """
        place = self.places[self.loaded_node()]
        return load * place.ratio / place.efficiency

    def loaded_node(self) -> str:
        """Return the node at which a stated load acts where no load of the rig has a mean.

        Raises
        ------
        InputError
            For a train with several ends and no load at one of them.
        """
        loaded = [one.on for one in self.terms if isinstance(one, Load) and one.on in self.places]
        if loaded:
            return loaded[0]
        springs = [one for one in springs_of(self.terms) if one.a in self.places and one.b in self.places]
        first = next(iter(self.places))
        ends = [
            node for node in self.places
            if node != first and sum(node in (spring.a, spring.b) for spring in springs) == 1
        ]  # fmt: skip
        if len(ends) > 1:
            raise InputError(
                f"the profile states a load torque, and no part says at which of {', '.join(ends)} it acts; add a "
                "particle_load there"
            )
        return ends[0] if ends else first

    def steady_torque(self, speed: float) -> float:
        """Return the motor torque [N m] at a constant speed [rad/s], including the Stribeck friction at that speed."""
        return self.needed(ShaftMotion(speed, 0.0, copysign(1.0, speed) if speed else 0.0, 1.0, 1.0))

    def needed(self, motion: ShaftMotion, further: Mapping[str, float] = NO_LOAD) -> float:
        """Return the motor torque [N m] for a motion of its shaft.

        Parameters
        ----------
        further : mapping of str to float
            Loads [N m] by node beyond those of the terms.
        """
        by_efficiency: dict[tuple[float, float], float] = {}
        for node, (ratio, *shares) in self.places.items():
            here = motion._replace(
                speed=motion.speed * ratio,
                acceleration=motion.acceleration * ratio,
                way=copysign(1.0, ratio) * motion.way,
            )
            needed = sum(one.needed_torque(node, here) for one in self.terms) + here.way * further.get(node, 0.0)
            key = (shares[0], shares[1])
            by_efficiency[key] = by_efficiency.get(key, 0.0) + needed * ratio
        heading = motion.way or copysign(1.0, motion.acceleration)
        return sum(
            _driven(torque, forwards) if torque * heading >= 0 else torque * backwards
            for (forwards, backwards), torque in by_efficiency.items()
        )


def _driven(torque: float, efficiency: float) -> float:
    """Return the torque before the losses [N m]; InputError where a wheel would drive a self-locking worm."""
    if torque and efficiency <= 0:
        raise InputError(
            "a self-locking worm_gear would be driven from its wheel, which does not turn; put the motor on its worm, "
            "or state a smaller friction"
        )
    return torque / efficiency if torque else torque


def driven_motor(rig: Rig) -> Motor | None:
    """Return the motor that follows the run's set-point, under a controller or on an inverter; None without one."""
    drives: tuple[SpeedController | InductionDrive, ...]
    drives = (*rig.parts_of(SpeedController), *rig.parts_of(InductionDrive))
    part = rig.part(drives[0].motor) if drives else None
    return part if isinstance(part, Motor) else None


def drive_train(rig: Rig, motor: str) -> DriveTrain:
    """Return the drive train of the node ``motor`` at the rig's operating point.

    The drives themselves are not asked, so that they may ask for it (ripple in proportion to the torque).
    """
    terms = passive_terms(rig)
    places = places_from(motor, springs_of(terms))
    ratios = rig.speed_ratios(motor)  # refuses inconsistent loops of gears
    return DriveTrain(terms=terms, places={node: place for node, place in places.items() if node in ratios})


def _chained(first: float, then: float) -> float:
    """Return the share of two stages in series [1]; one that locks keeps the chain locked."""
    return min(first, then) if min(first, then) <= 0 else first * then


def passive_terms(rig: Rig, *, without: str = "") -> tuple[Term, ...]:
    """Return the physics of all parts but the drives and the part ``without``."""
    drives = SpeedController | TorqueController | InductionDrive
    kept = [part for part in rig.parts if not isinstance(part, drives) and part.name != without]
    return tuple(term for part in kept for term in part.terms(rig))


def springs_of(terms: Iterable[Term]) -> tuple[Spring, ...]:
    """Return the springs among the terms."""
    return tuple(term for term in terms if isinstance(term, Spring))


def places_from(start: str, springs: Sequence[Spring]) -> dict[str, Place]:
    """Return the nodes that the springs connect to the node ``start``, with ratio and efficiency."""
    places, waiting = {start: Place(1.0, 1.0, 1.0)}, [start]
    while waiting:
        here = waiting.pop()
        for spring in springs:
            forth, back = spring.efficiency, spring.backwards
            ways = (
                (spring.a, spring.b, 1 / spring.ratio, forth, back),
                (spring.b, spring.a, spring.ratio, back, forth),
            )
            for near, far, turns, driving, driven in ways:
                if near == here and far not in places and far != GROUND:
                    place = places[here]
                    places[far] = Place(place.ratio * turns, _chained(place.efficiency, driving),
                                        _chained(place.backwards, driven))  # fmt: skip
                    waiting.append(far)
    return places
