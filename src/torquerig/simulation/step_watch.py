"""Check of the step while a run goes on: short stretches of it again with half the step, or from a disturbed state."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import copy
from dataclasses import dataclass
from math import exp, log

import numpy as np

from torquerig.simulation import kernel
from torquerig.simulation.arrays import Floats
from torquerig.simulation.kernel.work import copied, work_for
from torquerig.simulation.outputs import as_arrays
from torquerig.simulation.ready import Ready

ALLOWED = 1e-3  # [1] change by half the step, rms of a stretch over the rms of the whole signal
BURST = 100.0  # [1] largest change over the median one from which on it comes in bursts: bounces in a gap
STRETCHES = 8  # of a recording, evenly spread, and one more at each reversal of the set-point
SHARE, SHARE_IN_GAPS, LONGEST = 0.002, 0.005, 0.025  # [1, 1, s] length of one; each costs twice, for its step is half
DISTURBED, DISTURBED_LONGEST = 0.025, 0.1  # [1, s] length of the two stretches from a disturbed state
DISTURBANCE = 1e-7  # [1] of the speeds: far above rounding, and far below what a contact notices
PIECES = 8  # of a stretch from a disturbed state; what it has become is averaged over the last two


@dataclass(frozen=True)
class StepWatch:
    """What half the step, and a small disturbance, changes.

    Parameters
    ----------
    change : float
        Of what is measured by half the step, rms over a stretch, in parts of the rms of the recording [1].
    at : float
        Where that stretch starts [s].
    steps : int
        Per sample, of the run.
    allowed : float
        For ``change`` [1].
    growth : float
        Rate at which a small disturbance grows [1/s]; 0 where it does not.
    duration : float
        Of the recording [s].
    """

    change: float
    at: float
    steps: int
    allowed: float
    growth: float
    duration: float

    def sentences(self) -> Iterator[str]:
        """Yield a warning with its remedy where samples of the run depend on the step."""
        if self.change > self.allowed:
            yield (
                f"the integration step is too coarse: half the step changes the signal by {100 * self.change:.2g} % of "
                f"its rms at {self.at:.4g} s ({100 * self.allowed:g} % allowed); simulate with {4 * self.steps} steps "
                f"a sample in place of {self.steps}"
            )
        elif self.change * exp(min(700.0, self.growth * self.duration)) > ALLOWED:
            yield (
                "the motion is chaotic or unstable: a small change grows by a factor e in "
                f"{1000 / self.growth:.3g} ms; no step makes single samples reproducible; compare rms and spectra"
            )


def watched(run: Ready, kept: Floats) -> tuple[StepWatch, int, int]:
    """Fill ``kept`` as ``kernel.integrate`` does, to the same bits, and return the check and where the run failed.

    At the start of each stretch the state is copied and run on with half the step; so a stretch sees gaps, friction and
    loop as they are at that time, and not the start of the rig. Changes that come in bursts are allowed only half the
    share of the recording that the stretches see, because the others add up, and larger ones are among them. A rig that
    may make a difference grow is also run on from a disturbed state.
    """
    with np.errstate(over="ignore", invalid="ignore"):  # a run may be on its way to infinity
        return _watched(run, kept)


def _watched(run: Ready, kept: Floats) -> tuple[StepWatch, int, int]:
    course, span = _Course(run, kept), run.span
    changes, growths, seen = [(0.0, 0.0)], [], 0.0
    end = span.settling + span.samples
    for part, look in sorted(_stretches(run), key=lambda one: one[0].start):
        if part.start < course.here or part.stop > end:
            continue
        course.on(part.start)
        if look is _disturbed:
            growths.append(look(course, part.stop))
        else:
            changes.append((look(course, part.stop), (part.start - span.settling) / span.rate))
            seen += (part.stop - part.start) / span.samples
    course.on(end)
    size = rms(kept[0]) if course.failed[0] < 0 else 0.0
    change, at = max(changes)
    bursts = _has_gaps(run) and change > BURST * float(np.median([one for one, _ in changes]))
    grown = sum(growths) / len(growths) if growths else 0.0
    watch = StepWatch(
        change=change / size if size else 0.0, at=at, steps=run.steps, growth=max(0.0, grown),
        allowed=ALLOWED * (0.5 * seen if bursts else 1.0), duration=span.samples / span.rate,
    )  # fmt: skip
    return watch, *course.failed


class _Course:
    """The state of a run on its way; ``on`` changes it in place."""

    def __init__(self, run: Ready, kept: Floats) -> None:
        self.run, self.outputs, self.kept, self.first = run, as_arrays(run.outputs), kept, run.span.settling
        self.theta, self.omega = run.start()
        self.work = work_for(run.terms)
        self.here, self.failed = 0, (-1, -1)

    def on(self, until: int, *, finer: int = 1) -> None:
        """Step to the sample ``until``; nothing where the run has failed."""
        if self.failed[0] >= 0:
            return
        self.failed = kernel.integrate_part(
            self.theta, self.omega, self.work, self.run.terms, self.outputs, self.run.span.rate, self.first,
            finer * self.run.steps, self.kept, slice(self.here, until),
        )  # fmt: skip
        self.here = until

    def branched(self, until: int) -> _Course:
        """Return another course from the same state, for the samples up to ``until``."""
        other = copy(self)
        other.theta, other.omega, other.work = self.theta.copy(), self.omega.copy(), copied(self.work)
        other.kept, other.first = np.empty((self.kept.shape[0], until - self.here)), self.here
        return other


def _halved(course: _Course, until: int) -> float:
    """Run on to ``until``, and return the rms change of what is measured by half the step."""
    finer, start = course.branched(until), course.here - course.first
    finer.on(until, finer=2)
    course.on(until)
    if finer.failed[0] >= 0 or course.failed[0] >= 0:
        return np.inf
    moved = finer.kept[0] - course.kept[0, start : until - course.first]
    return rms(moved)


def _disturbed(course: _Course, until: int) -> float:
    """Run on to ``until``, and return the rate at which a disturbance of the speeds grows [1/s]; negative if it fades.

    Its size is the kinetic energy of the difference, which falls in every passive rig (Benettin et al. 1980, Meccanica
    15: the largest Lyapunov exponent).
    """
    moving = course.run.terms.inverse_inertia > 0
    inertia = np.divide(1.0, course.run.terms.inverse_inertia, where=moving, out=np.zeros(moving.size))
    pushed = np.sqrt(np.divide(1.0, inertia, where=moving, out=np.zeros(moving.size)))
    pushed *= np.where(np.arange(moving.size) % 2, -1.0, 1.0)
    pushed *= DISTURBANCE * np.sqrt(float(inertia @ course.omega**2) / max(1, int(moving.sum())))
    if not pushed.any():
        course.on(until)
        return 0.0
    start, first = course.here, course.branched(until)
    first.omega += pushed
    energies = []
    for piece in range(1, PIECES + 1):
        for one in (course, first):
            one.on(start + (until - start) * piece // PIECES)
        energies.append(float(inertia @ (course.omega - first.omega) ** 2))
    grown = (energies[-1] + energies[-2]) / 2 / float(inertia @ pushed**2)
    return log(max(grown, 1e-300)) / 2 / ((until - start) * (1 - 1 / PIECES) / course.run.span.rate)


def rms(values: Floats) -> float:
    """Return the root of the mean square, also of values whose squares are beyond a float."""
    largest = float(np.abs(values).max(initial=0.0))
    return largest * float(np.sqrt(np.mean((values / largest) ** 2))) if largest else 0.0


def _has_gaps(run: Ready) -> bool:
    return bool(run.terms.springs.half_gap.any())


def _may_grow(run: Ready) -> bool:
    """Whether two motions of a rig may part: by friction that falls with speed, or gears that lose by direction."""
    springs, frictions = run.terms.springs, run.terms.frictions
    return any((row > 0).any() for row in (springs.loss_forward, springs.loss_backward, frictions.excess))


def _stretches(run: Ready) -> Iterator[tuple[slice, Callable[[_Course, int], float]]]:
    """Yield the samples of each stretch, counted from the start of settling, and what is done there."""
    span, gaps = run.span, _has_gaps(run)
    whole = span.settling + span.samples
    length = max(2, int(min(LONGEST * span.rate, (SHARE_IN_GAPS if gaps else SHARE) * whole)))
    starts = [span.settling + int((one + 0.5) / STRETCHES * span.samples) for one in range(STRETCHES)]
    if run.terms.drives.on.size:
        wanted = run.terms.drives.reference[0, span.settling : whole]
        turned = np.flatnonzero(np.signbit(wanted[1:]) != np.signbit(wanted[:-1]))[:STRETCHES]
        starts += [span.settling + max(0, int(one) - length // 2) for one in turned]
    yield from ((slice(start, start + length), _halved) for start in starts)
    places = (0.13, 0.38, 0.63, 0.88) if gaps else (0.38, 0.88) if _may_grow(run) else ()  # between the others
    if places:
        length = max(PIECES, int(min(DISTURBED_LONGEST * span.rate, DISTURBED * whole)))
        for share in places:
            start = span.settling + int(share * span.samples)
            yield slice(start, start + length), _disturbed
