"""Two effects missing at once: alone each leaves the other, and gains too little to be believed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from torquerig.diagnosis.motion.evidence import gained, root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion, fitted
from torquerig.diagnosis.motion.moved import Moved
from torquerig.diagnosis.motion.objections import first_that_holds
from torquerig.diagnosis.motion.tried import Step, Tried
from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Rig

Beside = Callable[[FittedMotion, Rig, Sequence[Knob]], Sequence[Tried]]

_FIRSTS = 3  # of the hypotheses, that a second is tried beside
_LEAST = 0.1  # of the rms residual that the first of two takes away alone


def pair_that_holds(
    tried: Sequence[Tried], model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved], *,
    beside: Beside,
) -> tuple[Step, ...]:  # fmt: skip
    """Return the two steps of the first pair of which each holds beside the other; none where there is no such pair.

    Where a slow course and a line are left together, the colour of what either leaves makes few samples count. A
    second effect is looked for beside each of those that lower the residual most, and must hold there; the first must
    then hold beside the second, by the same rules.

    Parameters
    ----------
    tried : sequence of Tried
        The hypotheses, of which none was kept.
    beside : callable
        From a fitted model, its rig without the fit, and all its knobs to the hypotheses tried beside it.
    """
    for first in _firsts(tried):
        with_first, of_first = first.candidate.added_to(base), (*own, *first.candidate.knobs)
        seconds = tuple(beside(first.model, with_first, of_first))
        second, _ = first_that_holds(seconds, first.model, with_first, of_first, runs)
        if second is None:
            continue
        with_second, of_second = second.candidate.added_to(base), (*own, *second.candidate.knobs)
        start = np.concatenate([model.positions, np.zeros(len(second.candidate.knobs))])
        alone = fitted(with_second, runs, of_second, start=start)
        again = _beside(alone, first, second, runs)
        if first_that_holds([again], alone, with_second, of_second, runs)[0] is not None:
            kept = replace(first, gain=again.gain, fall=again.fall, beside=second.candidate.mechanism)
            others = tuple(one for one in tried if one is not first)
            return Step(kept, model, (kept, *others)), Step(second, first.model, seconds)
    return ()


def _firsts(tried: Sequence[Tried]) -> list[Tried]:
    """Return the hypotheses that lower the residual most, of each mechanism the first."""
    best: dict[str, Tried] = {}
    for one in tried:
        if one.freed and one.fall > _LEAST:
            best.setdefault(one.candidate.mechanism, one)
    return sorted(best.values(), key=lambda one: -one.fall)[:_FIRSTS]


def _beside(alone: FittedMotion, first: Tried, second: Tried, runs: Sequence[Moved]) -> Tried:
    """Return the first effect as tried beside the second, which is fitted ``alone``; ``second`` holds both."""
    before, left = alone.of(runs), second.model.of(runs)
    gain = gained(before, left, numbers=len(first.candidate.knobs))
    fall = 1 - root_mean_square(left) / root_mean_square(before)
    return Tried(first.candidate, second.model, gain, fall, freed=True)
