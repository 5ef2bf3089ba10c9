"""Which effects complete the model: each hypothesis fitted beside the model's own numbers, the best kept, and again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from torquerig.diagnose.case import Candidate
from torquerig.diagnose.fitting.knobs import Knob
from torquerig.diagnose.motion import cogging, friction, gap, hum, others
from torquerig.diagnose.motion.convincing import convincing, viscous_alone
from torquerig.diagnose.motion.evidence import LEAST_GAIN, gained, root_mean_square, samples_that_count
from torquerig.diagnose.motion.fitted import FittedMotion, fitted
from torquerig.diagnose.motion.moved import STRETCHES, Mask, Moved
from torquerig.diagnose.side_by_side import of_each
from torquerig.rig.rig import Rig

MOST_EFFECTS = 3
LEAST_FALL = 0.03  # of the rms residual: a smaller gain is no physics worth naming
_ALONE = 8  # evaluations while the model's own numbers are held
_AS_CLOSE = 0.05  # of the rms residual: what a simpler variant may leave more
_WORTHWHILE = 0.25  # of the best gain alone: less is not caught up by fitting all numbers
_ROOMS = (friction, gap, cogging, hum, others)


@dataclass(frozen=True, eq=False)
class Tried:
    """A hypothesis fitted together with all numbers of the model.

    Parameters
    ----------
    gain : float
        See ``evidence.gained``.
    fall : float
        By how much of itself the rms residual fell [1].
    freed : bool
        Whether all numbers of the model were fitted beside its own: only such a fit can be kept.
    """

    candidate: Candidate
    model: FittedMotion
    gain: float
    fall: float
    freed: bool = False


@dataclass(frozen=True, eq=False)
class Step:
    """A hypothesis that was kept, and all that were tried in its place."""

    kept: Tried
    before: FittedMotion
    tried: tuple[Tried, ...]


def completed(
    nominal: Rig, runs: Sequence[Moved], knobs: Sequence[Knob], *, progress: Callable[[str], None]
) -> tuple[FittedMotion, tuple[Step, ...], tuple[Tried, ...]]:
    """Return the calibrated nominal model, the steps that complete it, and what was tried last without being kept."""
    start = model = fitted(nominal, runs, knobs)
    base, own = nominal, tuple(knobs)
    steps: list[Step] = []
    last: tuple[Tried, ...] = ()
    while len(steps) < MOST_EFFECTS:
        progress(
            "trying the library's effects" if not steps else f"trying what {steps[-1].kept.candidate.mechanism} leaves"
        )
        last = tuple(_tried(model, base, own, runs))
        kept = _first_that_holds(last, model, base, own, runs)
        if kept is None:
            break
        steps.append(Step(kept, model, last))
        base, own = kept.candidate.added_to(base), (*own, *kept.candidate.knobs)
        model, last = kept.model, ()
    return start, tuple(steps), last


def _proposals(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    for room in _ROOMS:
        yield from room.propose(model, runs)


def _tried(model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]) -> list[Tried]:
    """Return every hypothesis fitted, best first: alone, then of each name and variant the best start with all.

    Alone all numbers of the model are held but those that stood in for the hypothesis.
    """

    def held(candidate: Candidate) -> Tried:
        loose = [knob for knob in own if knob.field in candidate.loosens]
        made = fitted(candidate.added_to(model.rig), runs, (*candidate.knobs, *loose), evaluations=_ALONE)
        return _weighed(candidate, made, model, runs)

    def freed(one: Tried) -> Tried:
        parts = tuple(one.model.rig.part(part.name) for part in one.candidate.parts)
        placed = replace(one.candidate, parts=parts)
        start = np.concatenate([model.positions, np.zeros(len(placed.knobs))])
        made = fitted(placed.added_to(base), runs, (*own, *placed.knobs), start=start)
        return replace(_weighed(placed, made, model, runs), freed=True)

    alone: dict[tuple[str, str], Tried] = {}
    for one in of_each(held, list(_proposals(model, runs))):
        key = (one.candidate.mechanism, one.candidate.variant)
        if key not in alone or one.gain > alone[key].gain:
            alone[key] = one
    worth = _worthwhile(list(alone.values()))
    found = [*of_each(freed, worth), *(one for one in alone.values() if one not in worth)]
    return _ranked(found, model, runs)


def _worthwhile(alone: Sequence[Tried]) -> list[Tried]:
    """Return those worth fitting with all numbers free.

    Of a residual that is one slow course few samples count, and no gain is large before it is gone: what lowers it
    counts as well.
    """
    top = max((one.gain for one in alone), default=0.0)
    deepest = max((one.fall for one in alone), default=0.0)
    enough = max(_WORTHWHILE * deepest, LEAST_FALL)
    return [one for one in alone if one.gain >= _WORTHWHILE * top or one.fall >= enough]


def _ranked(found: Sequence[Tried], model: FittedMotion, runs: Sequence[Moved]) -> list[Tried]:
    """Best first, all weighed with the colour of what the closest one leaves; finer variants behind one as close."""
    if not found:
        return []
    before, left = model.of(runs), [one.model.of(runs) for one in found]
    closest = min(left, key=root_mean_square)
    count = samples_that_count(closest)
    gains = [gained(before, after, numbers=len(one.candidate.knobs), count=count)
             for one, after in zip(found, left, strict=True)]  # fmt: skip
    best = sorted((replace(one, gain=gain) for one, gain in zip(found, gains, strict=True)), key=lambda one: -one.gain)
    return sorted(best, key=lambda one: any(_as_close(other, one) for other in best))


def _as_close(simple: Tried, fine: Tried) -> bool:
    """Whether a simpler variant of the same mechanism comes as close as a finer one."""
    alike = simple.freed and simple.candidate.mechanism == fine.candidate.mechanism
    fewer = len(simple.candidate.knobs) < len(fine.candidate.knobs)
    return alike and fewer and 1 - simple.fall < (1 + _AS_CLOSE) * (1 - fine.fall)


def _weighed(candidate: Candidate, made: FittedMotion, model: FittedMotion, runs: Sequence[Moved]) -> Tried:
    before, left = model.of(runs), made.of(runs)
    gain = gained(before, left, numbers=len(candidate.knobs))
    return Tried(candidate, made, gain, 1 - root_mean_square(left) / root_mean_square(before))


def _first_that_holds(
    tried: Sequence[Tried], model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]
) -> Tried | None:
    """Return the best that holds; none where viscous friction alone, which has no name, does better."""
    for one in tried:
        if lacks_viscous(one, runs):
            return None
        if _holds(one, model, base, own, runs):
            return one
    return None


def lacks_viscous(one: Tried, runs: Sequence[Moved]) -> bool:
    """Whether a hypothesis of dry friction gains by the viscous friction that comes with it, and no other way."""
    worth = one.freed and one.gain > LEAST_GAIN and one.fall > LEAST_FALL
    return worth and one.candidate.mechanism == "stribeck_friction" and viscous_alone(one.candidate, one.model, runs)


def _holds(one: Tried, model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]) -> bool:
    """Whether a gain is worth a name, and also lowers stretches that its own numbers were not fitted to."""
    if not one.freed or one.gain < LEAST_GAIN or one.fall < LEAST_FALL:
        return False
    if not convincing(one.candidate, one.model, model, runs):
        return False
    fit, check = _halves(runs)
    start = np.concatenate([model.positions, np.zeros(len(one.candidate.knobs))])
    knobs = (*own, *one.candidate.knobs)
    after = fitted(one.candidate.added_to(base), runs, knobs, start=start, masks=fit)
    before = fitted(base, runs, own, start=model.positions, masks=fit)
    left, first = ([each[mask] for each, mask in zip(made.residuals, check, strict=True) if mask.any()]
                   for made in (after, before))  # fmt: skip
    return root_mean_square(left) < (1 - 0.5 * LEAST_FALL) * root_mean_square(first)


def _halves(runs: Sequence[Moved]) -> tuple[list[Mask], list[Mask]]:
    """Return what fits may see, in stretches of a quarter of the usual, by turns."""
    fit, check = [], []
    for run in runs:
        turn = np.arange(run.seen.size) * STRETCHES * 4 // run.seen.size % 4 < 2
        fit.append(run.seen & turn)
        check.append(run.seen & ~turn)
    return fit, check
