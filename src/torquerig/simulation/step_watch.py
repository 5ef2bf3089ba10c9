"""Check of the step: a run with gaps again with half the step, other runs in short stretches, or from another state."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import copy
from dataclasses import dataclass
from math import exp, log

import numpy as np

from torquerig.simulation import kernel
from torquerig.simulation.arrays import Floats
from torquerig.simulation.kernel.work import copied, work_for
from torquerig.simulation.measured_places import Output
from torquerig.simulation.outputs import as_arrays
from torquerig.simulation.ready import Ready

ALLOWED = 1e-3  # [1] change by half the step, rms of a stretch over the rms of the whole signal
OF_HALF = 0.5  # [1] share of the error of a step that half the step takes away, where the order falls to one at impacts
AGAIN = 10.0  # [s] of a recording with gaps that is run again; the rest is seen in stretches
STRETCHES = 8  # of a recording, evenly spread, and one more at each reversal of the set-point
SHARE, LONGEST = 0.002, 0.025  # [1, s] length of one; each costs twice, for its step is half
DISTURBED, DISTURBED_LONGEST = 0.025, 0.1  # [1, s] length of the two stretches from a disturbed state
ROUNDING = 1e-16  # [1]
DISTURBANCE = 1e-7  # [1] of the speeds: far above rounding, and far below what a contact notices
PIECES = 8  # of a stretch from a disturbed state; what it has become is averaged over the last two


@dataclass(frozen=True)
class StepWatch:
    """What half the step, and a small disturbance, changes.

    Parameters
    ----------
    change : float
        Of what is measured by half the step, in parts of the rms of the recording [1]: with gaps rms over all that is
        run again, else over the stretch of the largest.
    at : float
        Where it is largest [s].
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
        if self.change > self.allowed and self.growth * self.duration < 1:
            yield (
                f"the integration step is too coarse: half the step changes the signal by {100 * self.change:.2g} % of "
                f"its rms at {self.at:.4g} s ({100 * self.allowed:g} % allowed); simulate with {4 * self.steps} steps "
                f"a sample in place of {self.steps}"
            )
        elif max(self.change, ROUNDING) * exp(min(700.0, self.growth * self.duration)) > ALLOWED:
            yield (
                "the motion is chaotic or unstable: a small change grows by a factor e in "
                f"{1000 / self.growth:.3g} ms; no step makes single samples reproducible; compare rms and spectra"
            )


def watched(run: Ready, kept: Floats) -> tuple[StepWatch, int, int]:
    """Fill ``kept`` as ``kernel.integrate`` does, to the same bits, and return the check and where the run failed.

    At the start of each stretch the state is copied and run on with half the step; so a stretch sees gaps, friction and
    loop as they are at that time, and not the start of the rig. A rig that may make a difference grow is also run on
    from a disturbed state.

    What a contact does depends on all contacts before it, also on those while the rig settled, and differences come in
    bursts. So a rig with gaps is run again from its start with half the step, up to ``AGAIN`` of the recording.
    """
    with np.errstate(over="ignore", invalid="ignore"):  # a run may be on its way to infinity
        return _watched(run, kept)


def _watched(run: Ready, kept: Floats) -> tuple[StepWatch, int, int]:
    course, span = _Course(run, kept), run.span
    changes, growths = [(0.0, 0.0)], []
    end = span.settling + span.samples
    for part, look in sorted(_stretches(run), key=lambda one: one[0].start):
        if part.start < course.here or part.stop > end:
            continue
        course.on(part.start)
        if look is _disturbed:
            growths.append(look(course, part.stop))
        else:
            changes.append((look(course, part.stop), (part.start - span.settling) / span.rate))
    course.on(end)
    gaps, failed = has_gaps(run), course.failed[0] >= 0
    if gaps and not failed:
        changes.append(_again(run, kept))
    size = 0.0 if failed else rms(kept[0])
    change, at = max(changes)
    grown = sum(growths) / len(growths) if growths else 0.0
    watch = StepWatch(
        change=change / size if size else 0.0, at=at, steps=run.steps, growth=max(0.0, grown),
        allowed=ALLOWED * (OF_HALF if gaps else 1.0), duration=span.samples / span.rate,
    )  # fmt: skip
    return watch, *course.failed


def _again(run: Ready, kept: Floats) -> tuple[float, float]:
    """Return the rms change of what is measured by half the step from the start of the rig on, and where most [s]."""
    span = run.span
    samples = min(span.samples, round(AGAIN * span.rate))
    finer = _Course(run, np.empty((1, samples)), outputs=run.outputs[:1])
    finer.on(span.settling + samples, finer=2)
    if finer.failed[0] >= 0:
        return np.inf, max(0, finer.failed[0] - span.settling) / span.rate
    moved = finer.kept[0] - kept[0, :samples]
    return rms(moved), float(np.abs(moved).argmax()) / span.rate


class _Course:
    """The state of a run on its way; ``on`` changes it in place."""

    def __init__(self, run: Ready, kept: Floats, *, outputs: tuple[Output, ...] | None = None) -> None:
        self.run, self.kept, self.first = run, kept, run.span.settling
        self.outputs = as_arrays(run.outputs if outputs is None else outputs)
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


def has_gaps(run: Ready) -> bool:
    """Return whether a spring of the rig has a gap."""
    return bool(run.terms.springs.half_gap.any())


def _may_grow(run: Ready) -> bool:
    """Whether two motions of a rig may part: by friction that falls with speed, or gears that lose by direction."""
    springs, frictions = run.terms.springs, run.terms.frictions
    return any((row > 0).any() for row in (springs.loss_forward, springs.loss_backward, frictions.excess))


def _stretches(run: Ready) -> Iterator[tuple[slice, Callable[[_Course, int], float]]]:
    """Yield the samples of each stretch, counted from the start of settling, and what is done there."""
    span, gaps = run.span, has_gaps(run)
    whole = span.settling + span.samples
    length = max(2, int(min(LONGEST * span.rate, SHARE * whole)))
    starts = [span.settling + int((one + 0.5) / STRETCHES * span.samples) for one in range(STRETCHES)]
    if gaps:
        starts = [start for start in starts if start >= span.settling + AGAIN * span.rate]
    elif run.terms.drives.on.size:
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
