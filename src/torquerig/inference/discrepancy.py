"""How far a right model may be off, estimated with the model: its sizes have priors as all parameters have.

A model that explains its rig badly everywhere has large sizes, and an effect must then stand out of more. The
logarithm of each size is normal about that of its median; the estimate is the maximum of likelihood and prior (type-II
maximum likelihood: MacKay 2003, Information Theory, Inference, and Learning Algorithms, 28).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.likelihood import KINDS_OF_SIZES, Discrepancy, log_density, residuals_of
from torquerig.inference.prediction.expected_run import ExpectedRun

Floats = NDArray[np.float64]

SPREAD = 0.8  # of the logarithm of each size: a factor of 2.2 up or down
_SMALLEST = 0.5  # times the median of each size
_OF_SPECTRA = ("line", "band", "mode", "modulation")
_LARGEST = {**dict.fromkeys(_OF_SPECTRA, float(np.exp(2 * SPREAD))), "level": 30.0, "level_floor": 30.0}  # times it:
# what exceeds two standard deviations in a spectrum is a missing part, and would hide the next one if it were allowed
_GRID = 7  # points of each search over one size
_SWEEPS = 2  # over all sizes; each then halves the distance of the points
_ALIKE = 0.1  # of the logarithm
MEDIAN = Discrepancy()


def log_prior(off: Discrepancy) -> float:
    """Return the logarithm of the prior density of the sizes, without constants [nats]."""
    logs = [np.log(getattr(off, size) / getattr(MEDIAN, size)) / SPREAD for size in KINDS_OF_SIZES]
    return -0.5 * float(np.square(logs).sum())


def usual(off: Discrepancy) -> Discrepancy:
    """Return the sizes, none larger than two standard deviations of its prior above the median."""
    most = {size: float(np.exp(2 * SPREAD)) * getattr(MEDIAN, size) for size in KINDS_OF_SIZES}
    return replace(off, **{size: min(getattr(off, size), limit) for size, limit in most.items()})


def estimated(seen: Sequence[RunFeatures], models: Sequence[ExpectedRun], start: Discrepancy) -> Discrepancy:
    """Return the sizes of the largest posterior density for given models of all runs, by a search along each size."""
    off = start
    width = np.log(max(_LARGEST.values()) / _SMALLEST) / (_GRID - 1)
    for sweep in range(_SWEEPS):
        for size, kinds in KINDS_OF_SIZES.items():
            median, here = getattr(MEDIAN, size), float(np.log(getattr(off, size)))
            low, high = np.log(_SMALLEST * median), np.log(_LARGEST[size] * median)
            points = np.linspace(low, high, _GRID) if sweep == 0 else here + width * np.linspace(-1, 1, _GRID)
            points = np.unique(np.clip(np.append(points, here), low, high))
            scores = [_score(seen, models, replace(off, **{size: float(np.exp(at))}), kinds) for at in points.tolist()]
            off = replace(off, **{size: float(np.exp(points[int(np.argmax(scores))]))})
        width /= 3
    return off


def is_near(one: Discrepancy, other: Discrepancy) -> bool:
    """Return whether all sizes agree so well that no fit changes."""
    return all(abs(np.log(getattr(one, size) / getattr(other, size))) < _ALIKE for size in KINDS_OF_SIZES)


def _score(
    seen: Sequence[RunFeatures], models: Sequence[ExpectedRun], off: Discrepancy, kinds: tuple[int, ...]
) -> float:
    total = sum(
        log_density(residuals_of(each, model, off, kind)) for each, model in zip(seen, models, strict=True)
        for kind in kinds
    )  # fmt: skip
    return total + log_prior(off)
