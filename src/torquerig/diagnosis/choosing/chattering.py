"""Flanks that chatter and never cross leave their spectrum alone: it tells that there is a gap, hardly how wide."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import sqrt

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.gap_fits import FittedGap, GapFits
from torquerig.diagnosis.choosing.opened_gap import ARCMIN, flanks_may_part, opened
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.parallel import parallel_map

_WIDTHS = (1.5, 5.0, 15.0, 45.0)  # [arcmin] over what gaps in service are
_ALIKE = 4.0  # of the misfit: 95 % of one number
# mean square residual of a run in which flanks may part [1]
_LEFT = 1.5  # below which chatter explains it: moments of another kind would leave more
_HOPELESS = 20.0  # which no further fit brings down so far


def told_by_chatter(fits: GapFits) -> FittedGap | None:
    """Return the gap whose chatter is the recordings', or None where a run stays unexplained in which flanks may part.

    Each width is fitted roughly first, and on where that comes anywhere near.
    """
    roughly = parallel_map(lambda width: fits.around(width * ARCMIN, derivatives=1), _WIDTHS)
    hopeful = [rough for rough in roughly if max(unexplained(fits.case, rough.model), default=np.inf) < _HOPELESS]
    if not hopeful:
        return None
    best = _of_like(fits.case, parallel_map(fits.better, hopeful))
    return best if max(unexplained(fits.case, best.model)) < _LEFT else None


def unexplained(case: Case, model: Calibrated) -> list[float]:
    """Return the mean square residual of each run in which flanks may part [1]."""
    pairs = zip(case.from_zero, model.misfits, strict=True)
    return [float(np.mean(misfit.all() ** 2)) for features, misfit in pairs if flanks_may_part(features)]


def _of_like(case: Case, fits: Sequence[FittedGap]) -> FittedGap:
    """Return the best of the fits, its gap in the middle of those that fit as well."""
    best = min(fits, key=lambda fit: fit.model.cost)
    alike = [fit.gap for fit in fits if fit.model.cost < best.model.cost + _ALIKE]
    if len(alike) < 2:
        return best
    within = (min(alike), max(alike))
    return replace(best, candidate=opened(case, sqrt(within[0] * within[1]), within=within))
