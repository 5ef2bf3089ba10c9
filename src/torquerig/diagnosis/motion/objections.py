"""What speaks against a hypothesis that gains: too little, another cause, or stretches that its numbers did not see."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from torquerig.diagnosis.motion.convincing import doubt_in, viscous_alone
from torquerig.diagnosis.motion.evidence import LEAST_GAIN, root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion, fitted
from torquerig.diagnosis.motion.moved import STRETCHES, Mask, Moved
from torquerig.diagnosis.motion.tried import Refused, Tried
from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Rig

LEAST_FALL = 0.03  # of the rms residual: a smaller gain is no physics worth naming


def first_that_holds(
    tried: Sequence[Tried], model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]
) -> tuple[Tried | None, tuple[Refused, ...]]:
    """Return the best hypothesis that is worth a name, and those before it with what speaks against them.

    None where viscous friction alone, which has no name, does better.
    """
    refused: list[Refused] = []
    for one in tried:
        why = _objection(one, model, base, own, runs)
        if not why:
            return one, tuple(refused)
        refused.append(Refused(one, why))
        if lacks_viscous(one, runs):
            break
    return None, tuple(refused)


def lacks_viscous(one: Tried, runs: Sequence[Moved]) -> bool:
    """Whether a hypothesis of dry friction gains by the viscous friction that comes with it, and no other way."""
    worth = one.freed and one.gain > LEAST_GAIN and one.fall > LEAST_FALL
    return worth and one.candidate.mechanism == "stribeck_friction" and viscous_alone(one.candidate, one.model, runs)


def _objection(one: Tried, model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]) -> str:
    """Return why a gain is not worth a name; empty where it lowers stretches too that its numbers did not see."""
    doubt = _too_little(one) or doubt_in(one.candidate, one.model, model, runs)
    if doubt:
        return doubt
    fit, check = _halves(runs)
    start = np.concatenate([model.positions, np.zeros(len(one.candidate.knobs))])
    knobs = (*own, *one.candidate.knobs)
    after = fitted(one.candidate.added_to(base), runs, knobs, start=start, masks=fit)
    before = fitted(base, runs, own, start=model.positions, masks=fit)
    left, first = ([each[mask] for each, mask in zip(made.residuals, check, strict=True) if mask.any()]
                   for made in (after, before))  # fmt: skip
    if root_mean_square(left) < (1 - 0.5 * LEAST_FALL) * root_mean_square(first):
        return ""
    return "it does not improve the prediction of stretches that its parameters were not fitted to"


def _too_little(one: Tried) -> str:
    """Return why what a hypothesis explains is too little for a name."""
    if one.gain <= 0:
        return "the log-likelihood rises by less than the penalty for its parameters"
    if one.fall < LEAST_FALL:
        return f"the residual falls by {one.fall:.1%}; a finding needs {LEAST_FALL:.0%}"
    if one.gain < LEAST_GAIN:
        return f"its gain is {one.gain:.3g}; a finding needs {LEAST_GAIN:g}"
    if not one.freed:
        return "added to the fitted model, it explains far less than other mechanisms"
    return ""


def _halves(runs: Sequence[Moved]) -> tuple[list[Mask], list[Mask]]:
    """Return what fits may see, in stretches of a quarter of the usual, by turns."""
    fit, check = [], []
    for run in runs:
        turn = np.arange(run.seen.size) * STRETCHES * 4 // run.seen.size % 4 < 2
        fit.append(run.seen & turn)
        check.append(run.seen & ~turn)
    return fit, check
