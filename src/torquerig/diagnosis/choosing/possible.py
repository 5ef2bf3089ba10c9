"""Whether the numbers that a fit gave an effect can be: some are told so loosely that chance puts them beyond."""

from __future__ import annotations

import numpy as np

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.hypotheses import is_likely, is_possible, told_loosely
from torquerig.inference.knobs import turned
from torquerig.rig.assembly import Rig

_95 = 1.96
_ODD = 20.0  # as much as two names for one line may differ by where neither is told


def can_be(candidate: Candidate, model: Calibrated) -> bool:
    """Whether the numbers of a candidate in the fitted ``model`` are such as can be.

    Those that its mechanism calls told loosely may stand at the end of their 95 % intervals that it names: one that is
    too large, or too small, by no more than chance is no reason to give the name to a rival.
    """
    return is_possible(candidate, model.rig) or is_possible(candidate, _at_their_ends(candidate, model))


def price_of_odd_numbers(candidate: Candidate, model: Calibrated) -> float:
    """Return what a candidate pays for fitted numbers that rigs hardly have, loosely told ones at their ends."""
    usual = is_likely(candidate, model.rig) or is_likely(candidate, _at_their_ends(candidate, model))
    return 0.0 if usual else _ODD


def _at_their_ends(candidate: Candidate, model: Calibrated) -> Rig:
    own, loose = {part.name for part in candidate.parts}, told_loosely(candidate)
    rows = [row for row, knob in enumerate(model.knobs) if knob.part in own and knob.field in loose]
    if not rows:
        return model.rig
    ends = np.array([loose[model.knobs[row].field] for row in rows])
    shifts = _95 * ends * np.sqrt(np.maximum(np.diag(model.covariance)[rows], 0.0))
    return turned(model.rig, [model.knobs[row] for row in rows], shifts)
