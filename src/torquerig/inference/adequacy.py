"""Whether a fitted model explains the features: the largest residual and their sum, by kind, as p-values.

Under the model the standardised residuals follow the likelihood's distribution, Student's. The largest of n has the
p-value ``1 - F(|z|)^n``; the sum of the deviances ``(nu + 1) ln(1 + z^2 / nu)`` is compared with a normal
distribution of their mean and variance, which holds for some ten features and more. The smallest p-value counts for
as many tests as there are (Bonferroni).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.discrepancy import usual
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit
from torquerig.inference.likelihood import BAND, DEGREES_OF_FREEDOM, LEVEL, LINE, Residuals, residuals
from torquerig.inference.load_spectrum import with_gains

Floats = NDArray[np.float64]

LEVEL_OF_TEST = 0.01  # p-value below which a model does not explain the data
_KINDS = {LINE: "lines", BAND: "bands", LEVEL: "levels"}


@dataclass(frozen=True)
class Excess:
    """One statistic of one kind of features.

    Parameters
    ----------
    statistic : str
        ``largest`` or ``sum``, with the kind.
    p_value : float
        For all tests together [1].
    run, kind, row : int
        Of the largest residual: which run, which kind, which of the run's residuals.
    size : float
        Of it in the reading [N m] rms.
    """

    statistic: str
    p_value: float
    run: int
    kind: int
    row: int
    size: float


def excesses_of(fit: Fit, data: Data, *, relevance: float) -> tuple[Excess, ...]:
    """Return the statistics of what a fitted model leaves, the least likely first.

    What is smaller than ``relevance`` [N m] rms in the reading does not count. The sizes of the discrepancy are the
    estimated ones, but no larger than is usual: a model that needs more does not explain its rig.
    """
    off = usual(fit.off)
    models = [with_gains(one, shape, fit.gains) for one, shape in zip(fit.expected, data.shapes, strict=True)]
    runs = [residuals(seen, model, off) for seen, model in zip(data.seen, models, strict=True)]
    return excesses(runs, [_sizes(seen, each) for seen, each in zip(data.seen, runs, strict=True)], relevance)


def excesses(runs: Sequence[Residuals], sizes: Sequence[Floats], relevance: float) -> tuple[Excess, ...]:
    """Return the same of residuals whose ``sizes`` [N m] are known, an array of shape (features,) for each run."""
    from scipy.stats import norm, t

    nu, found = DEGREES_OF_FREEDOM, list[Excess]()
    mean, variance = _deviance_moments()
    for kind, name in _KINDS.items():
        rows = [np.flatnonzero(each.kind == kind) for each in runs]
        values = [each.standardised[own] for each, own in zip(runs, rows, strict=True)]
        count = sum(each.size for each in values)
        if not count:
            continue
        least = float(t.isf(0.5 * LEVEL_OF_TEST / count, nu))  # of a residual that is no chance by itself
        large = [np.abs(value) * _counts(size[own], each.segment[own], np.abs(value) > least, relevance)
                 for value, size, own, each in zip(values, sizes, rows, runs, strict=True)]  # fmt: skip
        run = int(np.argmax([each.max(initial=0.0) for each in large]))
        if not large[run].any():
            continue
        row = int(np.argmax(large[run]))
        at, worst = int(rows[run][row]), float(large[run][row])
        largest = -np.expm1(count * np.log1p(-min(2 * float(t.sf(worst, nu)), 1 - 1e-16)))
        each = (nu + 1) * np.log1p(np.concatenate(values) ** 2 / nu)
        small = np.concatenate(large) == 0.0  # what does not count has at most the deviance of a true model
        deviance = float(np.where(small, np.minimum(each, mean), each).sum())
        total = float(norm.sf((deviance - count * mean) / np.sqrt(count * variance)))
        size = float(sizes[run][at])
        found += [Excess(f"largest of {name}", float(largest), run, kind, at, size),
                  Excess(f"sum of {name}", total, run, kind, at, size)]  # fmt: skip
    tests = max(len(found), 1)
    return tuple(sorted((replace(each, p_value=min(tests * each.p_value, 1.0)) for each in found),
                        key=lambda each: each.p_value))  # fmt: skip


def _counts(size: Floats, segment: NDArray[np.intp], is_odd: NDArray[np.bool_], relevance: float) -> NDArray[np.bool_]:
    """Return which residuals of one kind in a run count: those that are large, or odd and large together.

    Lines and bands of a segment add their mean squares, mean torques have their mean over the run.
    """
    counts = size > relevance
    for own in np.unique(segment).tolist():
        inside = segment == own
        share = 1 / max(int(inside.sum()), 1) if own < 0 else 1.0
        if np.sqrt(share * float(np.square(size[inside & is_odd]).sum())) > relevance:
            counts = counts | (inside & is_odd)
    return np.asarray(counts)


def _sizes(seen: RunFeatures, each: Residuals) -> Floats:
    """Return how large what is left is in the reading [N m] rms, shape (features,)."""
    size = seen.largest_level * np.abs(each.value)  # of levels
    line, band = each.kind == LINE, each.kind == BAND
    measured = seen.lines.power[each.segment[line], each.at[line]]
    size[line] = np.sqrt(0.5 * measured * np.abs(-np.expm1(-each.value[line])))
    width = (seen.bands.high - seen.bands.low)[each.at[band]]
    power = seen.band_power[each.segment[band], each.at[band]]
    size[band] = np.sqrt(width * power * np.abs(-np.expm1(-each.value[band])))
    return size


def _deviance_moments() -> tuple[float, float]:
    """Return mean and variance of the deviance of one residual."""
    from scipy.special import digamma, polygamma

    nu = DEGREES_OF_FREEDOM
    mean = (nu + 1) * float(digamma(0.5 * (nu + 1)) - digamma(0.5 * nu))
    return mean, (nu + 1) ** 2 * float(polygamma(1, 0.5 * nu) - polygamma(1, 0.5 * (nu + 1)))
