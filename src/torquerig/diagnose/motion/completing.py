"""Which effects complete the model: each hypothesis fitted beside the model's own numbers, the best kept, and again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from torquerig.diagnose.case import Candidate
from torquerig.diagnose.fitting.knobs import Knob
from torquerig.diagnose.motion import cogging, friction, gap, others
from torquerig.diagnose.motion.evidence import LEAST_GAIN, gained, root_mean_square, samples_that_count
from torquerig.diagnose.motion.fitted import FittedMotion, fitted
from torquerig.diagnose.motion.level import level_is_off
from torquerig.diagnose.motion.moved import STRETCHES, Mask, Moved
from torquerig.rig.rig import Rig

MOST_EFFECTS = 3
LEAST_FALL = 0.03  # of the rms residual: a smaller gain is no physics worth naming
_OF_THE_LEVEL = ("quadratic_drag", "sensor_drift")
_ALONE = 8  # evaluations while the model's own numbers are held
_WORTHWHILE = 0.25  # of the best gain alone: less is not caught up by fitting all numbers
_ROOMS = (friction, gap, cogging, others)


@dataclass(frozen=True, eq=False)
class Tried:
    """A hypothesis fitted together with all numbers of the model.

    Parameters
    ----------
    gain : float
        See ``evidence.gained``.
    fall : float
        By how much of itself the rms residual fell [1].
    """

    candidate: Candidate
    model: FittedMotion
    gain: float
    fall: float


@dataclass(frozen=True, eq=False)
class Step:
    """A hypothesis that was kept, and all that were tried in its place."""

    kept: Tried
    before: FittedMotion
    tried: tuple[Tried, ...]


@dataclass(frozen=True, eq=False)
class Refused:
    """A hypothesis that was not kept beside the findings, and why."""

    tried: Tried
    why: str


def completed(
    nominal: Rig, runs: Sequence[Moved], knobs: Sequence[Knob], *, progress: Callable[[str], None]
) -> tuple[FittedMotion, tuple[Step, ...], tuple[Refused, ...]]:
    """Return the calibrated nominal model, the steps that complete it, and what was tried last without being kept."""
    start = model = fitted(nominal, runs, knobs)
    base, own = nominal, tuple(knobs)
    steps: list[Step] = []
    while len(steps) < MOST_EFFECTS:
        progress(
            "trying the library's effects" if not steps else f"trying what {steps[-1].kept.candidate.mechanism} leaves"
        )
        tried = tuple(_tried(model, base, own, runs))
        kept, refused = _first_that_holds(tried, model, base, own, runs)
        if kept is None:
            return start, tuple(steps), refused
        steps.append(Step(kept, model, tried))
        base, own = kept.candidate.added_to(base), (*own, *kept.candidate.knobs)
        model = kept.model
    return start, tuple(steps), ()


def _proposals(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    for room in _ROOMS:
        yield from room.propose(model, runs)


def _tried(model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]) -> list[Tried]:
    """Return every hypothesis fitted, best first: alone, then of each name and variant the best start with all."""
    alone: dict[tuple[str, str], Tried] = {}
    for candidate in _proposals(model, runs):
        made = fitted(candidate.added_to(model.rig), runs, candidate.knobs, evaluations=_ALONE)
        one = _weighed(candidate, made, model, runs)
        key = (candidate.mechanism, candidate.variant)
        if key not in alone or one.gain > alone[key].gain:
            alone[key] = one
    top = max((one.gain for one in alone.values()), default=0.0)
    found = []
    for one in alone.values():
        if one.gain < _WORTHWHILE * top:
            found.append(one)
            continue
        parts = tuple(one.model.rig.part(part.name) for part in one.candidate.parts)
        placed = replace(one.candidate, parts=parts)
        start = np.concatenate([model.positions, np.zeros(len(placed.knobs))])
        made = fitted(placed.added_to(base), runs, (*own, *placed.knobs), start=start)
        found.append(_weighed(placed, made, model, runs))
    return _ranked(found, model, runs)


def _ranked(found: Sequence[Tried], model: FittedMotion, runs: Sequence[Moved]) -> list[Tried]:
    """Best first, all weighed with the colour of what the closest one leaves."""
    if not found:
        return []
    before, left = model.of(runs), [one.model.of(runs) for one in found]
    closest = min(left, key=root_mean_square)
    count = samples_that_count(closest)
    gains = [gained(before, after, numbers=len(one.candidate.knobs), count=count)
             for one, after in zip(found, left, strict=True)]  # fmt: skip
    return sorted((replace(one, gain=gain) for one, gain in zip(found, gains, strict=True)), key=lambda one: -one.gain)


def _weighed(candidate: Candidate, made: FittedMotion, model: FittedMotion, runs: Sequence[Moved]) -> Tried:
    before, left = model.of(runs), made.of(runs)
    gain = gained(before, left, numbers=len(candidate.knobs))
    return Tried(candidate, made, gain, 1 - root_mean_square(left) / root_mean_square(before))


def _first_that_holds(
    tried: Sequence[Tried], model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]
) -> tuple[Tried | None, tuple[Refused, ...]]:
    """Return the best hypothesis that is worth a name, and those before it with what speaks against them."""
    refused: list[Refused] = []
    for one in tried:
        why = _objection(one, model, base, own, runs)
        if not why:
            return one, tuple(refused)
        refused.append(Refused(one, why))
    return None, tuple(refused)


def _objection(one: Tried, model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]) -> str:
    """Return why a gain is not worth a name; empty where it lowers stretches too that its numbers did not see."""
    if one.gain <= 0:
        return "what is left falls by less than its numbers cost"
    if one.fall < LEAST_FALL:
        return f"what is left falls by {one.fall:.1%}, and a name needs {LEAST_FALL:.0%}"
    if one.gain < LEAST_GAIN:
        return f"its gain is {one.gain:.3g}, and a name needs {LEAST_GAIN:g}"
    if one.candidate.mechanism in _OF_THE_LEVEL and level_is_off(one.model, runs):
        return "it bends the level the right way, which stays wrong at some speeds: it would stand for something else"
    fit, check = _halves(runs)
    start = np.concatenate([model.positions, np.zeros(len(one.candidate.knobs))])
    knobs = (*own, *one.candidate.knobs)
    after = fitted(one.candidate.added_to(base), runs, knobs, start=start, masks=fit)
    before = fitted(base, runs, own, start=model.positions, masks=fit)
    left, first = ([each[mask] for each, mask in zip(made.residuals, check, strict=True) if mask.any()]
                   for made in (after, before))  # fmt: skip
    if root_mean_square(left) < (1 - 0.5 * LEAST_FALL) * root_mean_square(first):
        return ""
    return "stretches that its own numbers were not fitted to are foretold no better"


def _halves(runs: Sequence[Moved]) -> tuple[list[Mask], list[Mask]]:
    """Return what fits may see, in stretches of a quarter of the usual, by turns."""
    fit, check = [], []
    for run in runs:
        turn = np.arange(run.seen.size) * STRETCHES * 4 // run.seen.size % 4 < 2
        fit.append(run.seen & turn)
        check.append(run.seen & ~turn)
    return fit, check
