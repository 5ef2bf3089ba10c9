"""The inputs of a run at every sample (set-points, demands, loads, imposed motions) and its initial state."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import random_for
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import AppliedTorque, Drive, ImposedMotion, Load, LoadProcess, Signal
from torquerig.simulation.lower import Lowered
from torquerig.simulation.profile import loads_as_planned, set_point
from torquerig.simulation.term_kinds import Terms
from torquerig.simulation.term_kinds.imposed import Imposed

NEVER = np.iinfo(np.int64).max


@dataclass(frozen=True, kw_only=True)
class Span:
    """The samples of a run: ``settling`` that are not kept, ``samples`` that are, at ``rate`` [Hz], and its seed.

    ``phase_seed`` fixes the phases of the machine's lines; None: the seed does.
    """

    settling: int
    samples: int
    rate: float
    seed: int
    wander: float = 0.0
    phase_seed: int | None = None

    @classmethod
    def of(
        cls, *, duration: float, settling: float, rate: float, seed: int, wander: float, phase_seed: int | None = None
    ) -> Span:
        """Return the span of a recording of ``duration`` [s] after ``settling`` [s]."""
        return cls(
            settling=round(settling * rate), samples=round(duration * rate), rate=rate, seed=seed, wander=wander,
            phase_seed=phase_seed,
        )  # fmt: skip

    def time(self) -> NDArray[np.float64]:
        """Return the time of every sample and one more [s], shape (settling + samples + 1,); 0 is the first kept."""
        return np.arange(-self.settling, self.samples + 1) / self.rate


def held_while_settling(lowered: Lowered, span: Span) -> Lowered:
    """Return the rig held at its set-point until the recording starts, where nothing else holds its speed.

    Without this a rig in torque mode would run away, or stand still, for a time that nobody recorded.
    """
    held = any(drive.holds_speed for drive in lowered.drive_terms) or lowered.imposed_terms
    if held or span.settling == 0:
        return lowered
    return lowered.imposing(ImposedMotion(name="settling", on=lowered.leader(), released=True))


class Draws:
    """The random courses drawn so far, for runs that have them in common; the newest few are kept.

    Safe to share between threads: at worst a course is drawn twice, and is the same both times.
    """

    KEPT = 8  # courses; each is as long as a run

    def __init__(self) -> None:
        self._kept: dict[Hashable, NDArray[np.float64]] = {}

    def load(self, name: str, process: LoadProcess, span: Span, count: int) -> NDArray[np.float64]:
        """Return ``count`` samples of a load [N m], which nobody may change."""

        def drawn() -> NDArray[np.float64]:
            return process.sample(count, span.rate, random_for(span.seed, name))

        return self._once((name, process, span.seed, span.rate, count), drawn)

    def set_point(self, run: Run, span: Span) -> NDArray[np.float64]:
        """Return the set-point of the speed with its wander [rad/s], which nobody may change."""

        def drawn() -> NDArray[np.float64]:
            return set_point(
                run, settling=span.settling, samples=span.samples, rate=span.rate, wander=span.wander,
                rng=random_for(span.seed, "speed wander"),
            )  # fmt: skip

        # the notes of a sidecar, which are not compared, change nothing of it
        conditions = (getattr(run, one.name) for one in fields(run) if one.name != "others")
        return self._once((*conditions, replace(span, phase_seed=None)), drawn)

    def _once(self, key: Hashable, drawn: Callable[[], NDArray[np.float64]]) -> NDArray[np.float64]:
        try:
            made = self._kept.get(key)
        except TypeError:  # what holds arrays is not compared
            return drawn()
        if made is None:
            made = drawn()
            made.flags.writeable = False
            self._kept = {**dict(list(self._kept.items())[1 - self.KEPT :]), key: made}
        return made


def filled(rig: Rig, lowered: Lowered, span: Span, draws: Draws | None = None) -> Terms:
    """Return the rig's arrays with the inputs at every sample."""
    held, count = Draws() if draws is None else draws, span.settling + span.samples + 1
    reference = held.set_point(rig.run, span)
    demands = [_demand(rig, drive, span) for drive in lowered.drive_terms]
    loads = given_torques(rig, lowered.load_terms, span, held)
    return lowered.arrays._replace(
        loads=lowered.arrays.loads._replace(samples=_stacked(loads, count)),
        drives=lowered.arrays.drives._replace(
            reference=np.tile(reference, (len(demands), 1)), demand=_stacked(demands, count)
        ),
        imposed=_imposed(lowered, span, reference),
    )


def given_torques(
    rig: Rig, terms: Sequence[Load | AppliedTorque], span: Span, draws: Draws | None = None
) -> list[NDArray[np.float64]]:
    """Return each load and applied torque at every sample [N m], by the profile of the run."""
    held = Draws() if draws is None else draws
    return loads_as_planned(
        rig.run, [_torque(term, span, held) for term in terms], terms,
        settling=span.settling, samples=span.samples, rate=span.rate,
    )  # fmt: skip


def start(rig: Rig, lowered: Lowered, terms: Terms) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return angles and speeds, shape (nodes + 1,): everything turns with the leader, springs without torque."""
    leader = lowered.leader()
    leading = [row for row, term in enumerate(lowered.imposed_terms) if term.on == leader]
    angle = terms.imposed.angle[leading[0], 0] if leading else 0.0
    speed = terms.imposed.speed[leading[0], 0] if leading else (rig.run.speed or 0.0)
    if lowered.drive_terms and not leading:
        speed = terms.drives.reference[0, 0]
    ratios = rig.speed_ratios(leader)
    turned = np.array([ratios.get(node, 0.0) for node in lowered.nodes] + [0.0])
    return angle * turned + unloaded(lowered), speed * turned


def unloaded(lowered: Lowered) -> NDArray[np.float64]:
    """Return the angles [rad] at which the springs hold no torque, shape (nodes + 1,), seen from the frame or leader.

    All zero where no spring has a rest angle. Where two paths contradict, the first one counts.
    """
    springs, ground = lowered.arrays.springs, len(lowered.nodes)
    angles = np.zeros(ground + 1)
    if not springs.rest.any():
        return angles
    known = np.zeros(ground + 1, dtype=bool)
    for root in (ground, lowered.node(lowered.leader())):
        known[root] = True
        for _ in range(springs.a.size):
            for a, b, r, rest in zip(springs.a, springs.b, springs.inverse_ratio, springs.rest, strict=True):
                if known[a] and not known[b]:
                    angles[b], known[b] = angles[a] * r - rest, True
                elif known[b] and not known[a]:
                    angles[a], known[a] = (angles[b] + rest) / r, True
    return angles


def _demand(rig: Rig, drive: Drive, span: Span) -> NDArray[np.float64]:
    """Return the torque demand in addition to the speed loop [N m]."""
    demand = np.zeros(span.settling + span.samples + 1)
    if not drive.torque and drive.demand is None:
        return demand
    time = span.time()
    if drive.torque:
        top = rig.run.speed or 1.0
        course = rig.run.speed_profile().speed(np.maximum(0.0, time), top=top, duration=span.samples / span.rate)
        demand += drive.torque / top * course
    if drive.demand is not None:
        demand += drive.demand.at(time)
    return demand


def _torque(term: Load | AppliedTorque, span: Span, draws: Draws) -> NDArray[np.float64]:
    if isinstance(term.process, Signal):
        return term.process.at(span.time())
    return draws.load(term.name, term.process, span, span.settling + span.samples + 1)


def _imposed(lowered: Lowered, span: Span, reference: NDArray[np.float64]) -> Imposed:
    if not lowered.imposed_terms:
        none = np.empty((0, span.settling + span.samples + 1))
        return lowered.arrays.imposed._replace(release=np.empty(0, dtype=np.int64), angle=none, speed=none)
    time = span.time()
    angles, speeds = [], []
    for term in lowered.imposed_terms:
        if term.motion is None:
            speed = term.factor * reference
            angle = np.concatenate([[0.0], np.cumsum(0.5 * (speed[1:] + speed[:-1]))]) / span.rate
            if term.released:  # it holds the rig where its springs are unloaded
                angle += unloaded(lowered)[lowered.node(term.on)]
        else:
            angle, speed = term.motion.at(time)
        angles.append(angle)
        speeds.append(speed)
    return lowered.arrays.imposed._replace(
        release=np.array([span.settling if term.released else NEVER for term in lowered.imposed_terms], dtype=np.int64),
        angle=_stacked(angles, time.size),
        speed=_stacked(speeds, time.size),
    )


def _stacked(rows_: list[NDArray[np.float64]], count: int) -> NDArray[np.float64]:
    return np.array(rows_, dtype=np.float64).reshape(-1, count)
