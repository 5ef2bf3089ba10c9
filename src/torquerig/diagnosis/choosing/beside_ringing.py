"""Impacts and what looks like modes or a low-pass beside them: how impacts ring is another's law."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.misfit import robust_squares

_OF_RINGING = 0.4  # of what impacts gained, their details may gain
_FAR_BELOW = 0.25  # of the frequency at which they ring
_MOST = 0.5  # of a gain


def details_of_ringing(case: Case, trial: Trial, earlier: Sequence[Trial]) -> list[float]:
    """Return what details of impacts that were found earlier may gain where the trial resembles them.

    Nothing where most of its gain lies far below their ringing, in bands that they leave to the shafts.
    """
    if not trial.candidate.resembled:
        return []
    struck = [each for each in earlier if each.candidate.mechanism == "bearing_defect"]
    return [_OF_RINGING * each.gain for each in struck if not _far_below(case, trial, each)]


def _far_below(case: Case, trial: Trial, struck: Trial) -> bool:
    rings = [float(part.ring_frequency) for part in struck.candidate.parts if hasattr(part, "ring_frequency")]
    below, gained = _FAR_BELOW * min(rings, default=0.0), 0.0
    for seen, before, after in zip(case.seen, case.model.misfits, trial.model.misfits, strict=True):
        if before.bands.size:
            missed = robust_squares(before.bands) - robust_squares(after.bands)
            gained += float(np.sum(missed[seen.band < below]))
    return gained > _MOST * trial.gain
