"""Whether the slow torque of a moving run jumps from stretch to stretch, as no load and no friction makes it.

What is wrong with friction, drag or inertia leaves a course along the speed that is smooth; a zero or a load that jumps
at random leaves each stretch by itself. On 53 moving runs of seed 92, effects of every class among them, the scatter
was 1.24 spreads at most; a zero that jumped made 1.7 and 6.3, jumps of the time base 2.0.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import log10, sqrt

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.misfit import robust_squares
from torquerig.diagnosis.judging.chance import beyond_chance
from torquerig.inference.answer.mismatch import Mismatch

_FEWEST = 8  # stretches
_CHANCE, _UNDER_LOAD = 1e-3, 1e-6  # a load wanders by a law of its own, which the model knows by its power alone


def scatter(levels: NDArray[np.float64]) -> float:
    """Return by how much each level stands off the mean of its two neighbours, in its own spread (rms).

    Independent levels of unit spread have 1, whatever smooth course they follow (von Neumann 1941, Ann. Math. Stat.
    12).

    Parameters
    ----------
    levels : ndarray, shape (stretches,)
        Residuals in units of their spread, in the order of time.
    """
    return sqrt(float(np.mean(_apart(levels) ** 2)) / 1.5)


def scattered_levels(case: Case, total: float) -> Iterator[Mismatch]:
    """Yield the moving runs whose levels scatter more than what the model calls chance; ``total`` as in ``leftover``.

    Nothing is asked where an effect beyond the twin is in the model: flanks meet when they like.
    """
    if case.model.corrections:
        return
    moving = [
        (features, misfit.level)
        for features, misfit in zip(case.seen, case.model.misfits, strict=True)
        if not features.observed.steady and misfit.level.size >= _FEWEST
    ]
    for features, levels in moving:
        size, free = scatter(levels), levels.size - 2
        p_value = min(1.0, len(moving) * float(chi2.sf(free * size**2, free)))
        if p_value > (_UNDER_LOAD if features.observed.run.occupancy_percent else _CHANCE):
            continue
        worst = features.parts[int(np.argmax(np.abs(_apart(levels)))) + 1]
        start, stop = (sample / features.observed.rate for sample in (worst.start, worst.stop))
        yield Mismatch(
            domain="time", axis="s", at=0.5 * (start + stop), width=stop - start,
            recordings=(features.observed.name,), excess_dB=20 * log10(size),
            share_of_misfit=beyond_chance(robust_squares(levels)) / total, p_value=p_value,
        )  # fmt: skip


def _apart(levels: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return by how much each level but the outer two stands off the mean of its neighbours."""
    return np.asarray(levels[1:-1] - 0.5 * (levels[:-2] + levels[2:]))
