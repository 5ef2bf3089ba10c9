"""Whether a fitted model explains the features: the largest residual and the sums, by kind and in all, as p-values.

Fitted and held-out blocks are tested together. Under the model the standardised residuals follow the likelihood's
distribution, Student's. The largest of n has the p-value ``1 - F(|z|)^n``; the sum of the deviances
``(nu + 1) ln(1 + z^2 / nu)`` is compared with a normal distribution of their mean and variance, which holds for some
ten features and more. What is spread over many features, each of them small, shows in the sums. A line or a band that
changes within a run at one speed shows in its blocks (``unsteady``). The smallest p-value counts for as many tests as
there are (Bonferroni). A line or a band that is too high in many segments, by too little in each, shows in its mean.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.discrepancy import usual
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit, all_residuals
from torquerig.inference.held_out import held_residuals
from torquerig.inference.likelihood import (
    BAND,
    DEGREES_OF_FREEDOM,
    LEVEL,
    LINE,
    Discrepancy,
    Residuals,
    deviance_moments,
)  # fmt: skip
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.inference.unsteady import Change, changes

Floats = NDArray[np.float64]

LEVEL_OF_TEST = 0.01  # p-value below which a model does not explain the data
_NOTHING_WRONG = Discrepancy(line=0.0, band=0.0, mode=0.0, modulation=0.0, level=0.0, level_floor=0.0)
_CHANGE = "change"
_KINDS = {LINE: "lines", BAND: "bands", LEVEL: "levels"}


@dataclass(frozen=True)
class Excess:
    """One statistic of one kind of features, or of all.

    Parameters
    ----------
    statistic : str
        ``largest``, ``sum`` or ``mean``, with the kind; ``change`` of a line or a band within a run at one speed.
    p_value : float
        For all tests together [1].
    run, kind, row : int
        Of the largest residual: which of the tested runs, which kind, which of the run's residuals.
    size : float
        Of it in the reading [N m] rms.
    """

    statistic: str
    p_value: float
    run: int
    kind: int
    row: int
    size: float

    @property
    def changes(self) -> bool:
        """Whether it is a change within runs."""
        return self.statistic.startswith(_CHANGE)


@dataclass(frozen=True)
class JudgedRun:
    """Features of the fitted or the held-out blocks of one run, and what a model leaves of them.

    Parameters
    ----------
    seen : RunFeatures
    residuals : Residuals
    size : ndarray, shape (features,)
        Of each residual in the reading [N m] rms, as of an effect that is added to the model.
    excess : mapping of int to float
        By kind, the mean square [(N m)^2] by which the error of the model exceeds what its standard deviations permit.
    common : ndarray, shape (features,), optional
        Standard deviation of what a right model may be wrong by, over that of the residual [1].
    """

    seen: RunFeatures
    residuals: Residuals
    size: Floats
    excess: Mapping[int, float]
    common: Floats | None = None


def judged_run(seen: RunFeatures, each: Residuals, sampled: Residuals | None = None) -> JudgedRun:
    """Return the residuals of a run with their sizes; ``sampled`` are those of a model that is wrong by nothing."""
    size, square, permitted = _sizes(seen, each)
    weight = np.ones(each.value.size)
    lengths = np.array([sum(block.stop - block.start for block in one.blocks) for one in seen.segments], dtype=float)
    spectral = each.segment >= 0
    weight[spectral] = (lengths / max(lengths.sum(), 1.0))[each.segment[spectral]]
    weight[~spectral] = 1 / max(int((~spectral).sum()), 1)
    beyond = weight * (square - permitted)
    common = None if sampled is None else np.sqrt(np.maximum(1 - (sampled.sd / each.sd) ** 2, 0.0))
    return JudgedRun(seen, each, size, {kind: float(beyond[each.kind == kind].sum()) for kind in _KINDS}, common)


def judged_runs(fit: Fit, data: Data, held: Data) -> tuple[JudgedRun, ...]:
    """Return the runs with fitted blocks and those with held-out ones, and what a model leaves of them."""
    fit = replace(fit, off=usual(fit.off))
    given, sampled = (
        (*all_residuals(data, fit.expected, fit.gains, off), *held_residuals(replace(fit, off=off), held))
        for off in (fit.off, _NOTHING_WRONG)
    )
    seen = (*data.seen, *held.seen)
    return tuple(judged_run(*each) for each in zip(seen, given, sampled, strict=True))


def excesses_of(
    fit: Fit, data: Data, held: Data, *, relevance: float
) -> tuple[tuple[Excess, ...], tuple[JudgedRun, ...]]:
    """Return the statistics of what a fitted model leaves, the least likely first, and the runs.

    What is smaller than ``relevance`` [N m] rms in the reading does not count. The sizes of the discrepancy are the
    estimated ones, but no larger than is usual: a model that needs more does not explain its rig.
    """
    runs = judged_runs(fit, data, held)
    models = (*fit.expected, *(expected_run(fit.fitted_rig, one) for one in held.seen))
    changed = changes([(each.seen, model) for each, model in zip(runs, models, strict=True)])
    return excesses(runs, relevance, changed=changed), runs


def excesses(runs: Sequence[JudgedRun], relevance: float, *, changed: Sequence[Change] = ()) -> tuple[Excess, ...]:
    """Return the statistics of tested runs; ``changed`` is what may change within them."""
    found = [each for kind in _KINDS for each in _of_kind(runs, kind, relevance)]
    if found:
        found.append(_sum_of(runs, tuple(_KINDS), relevance, min(found, key=lambda each: each.p_value)))
        found += [*_changing(runs, changed, relevance), *_means(runs, relevance)]
    tests = max(len(found), 1)
    return tuple(sorted((replace(each, p_value=min(tests * each.p_value, 1.0)) for each in found),
                        key=lambda each: each.p_value))  # fmt: skip


def _of_kind(runs: Sequence[JudgedRun], kind: int, relevance: float) -> list[Excess]:
    """Return the largest residual of one kind, and the sum; none where there are no such features."""
    from scipy.stats import t

    nu = DEGREES_OF_FREEDOM
    rows = [np.flatnonzero(each.residuals.kind == kind) for each in runs]
    count = sum(own.size for own in rows)
    if not count:
        return []
    least = float(t.isf(0.5 * LEVEL_OF_TEST / count, nu))  # of a residual that is no chance by itself
    values = [np.abs(each.residuals.standardised[own]) for each, own in zip(runs, rows, strict=True)]
    large = [value * _counts(each.size[own], each.residuals.segment[own], value > least, relevance)
             for each, value, own in zip(runs, values, rows, strict=True)]  # fmt: skip
    run = max(range(len(runs)), key=lambda one: (large[one].max(initial=0.0), values[one].max(initial=0.0)))
    row = int(np.argmax(large[run] if large[run].any() else values[run]))
    worst, at = float(large[run][row]), int(rows[run][row])
    p_value = -np.expm1(count * np.log1p(-min(2 * float(t.sf(worst, nu)), 1 - 1e-16)))
    first = Excess(f"largest of {_KINDS[kind]}", float(p_value), run, kind, at, float(runs[run].size[at]))
    return [first, _sum_of(runs, (kind,), relevance, first)]


def _changing(runs: Sequence[JudgedRun], changed: Sequence[Change], relevance: float) -> Iterator[Excess]:
    """Yield the line and the band that change least probably by random errors, of those whose change counts."""
    for kind in (LINE, BAND):
        own = [each for each in changed if each.kind == kind]
        for each in own:
            of_run = runs[each.run].residuals
            rows = np.flatnonzero((of_run.kind == kind) & (of_run.at == each.row) & (of_run.segment == each.segment))
            if rows.size and each.size > relevance:
                p_value = -np.expm1(len(own) * np.log1p(-min(each.p_value, 1 - 1e-16)))
                yield Excess(f"{_CHANGE} of {_KINDS[kind]}", float(p_value), each.run, kind, int(rows[0]), each.size)
                break


def _means(runs: Sequence[JudgedRun], relevance: float) -> Iterator[Excess]:
    """Yield the line and the band of which the mean residual over all segments is the least probable by chance.

    What a right model may be wrong by in one place is the same in all segments, so it does not average out: with c the
    share of it in each standard deviation, the sum of n standardised residuals has the variance
    ``n v + (sum c)^2 - sum c^2``, v that of Student's distribution. The sum has the kurtosis of one of 4 + 4 n degrees.
    """
    from scipy.stats import t

    nu = DEGREES_OF_FREEDOM
    for kind in (LINE, BAND):
        places = dict[tuple[str, float], list[tuple[float, float, int, int]]]()
        for run, each in enumerate(runs):
            shares = np.zeros(0) if each.common is None else each.common
            for row in np.flatnonzero(each.residuals.kind[: shares.size] == kind).tolist():
                where = _place_of(each.seen, kind, int(each.residuals.at[row]))
                value, common = float(each.residuals.standardised[row]), float(shares[row])
                places.setdefault(where, []).append((value, common, run, row))
        found = list[Excess]()
        for rows in places.values():
            value, common = np.array([each[:2] for each in rows]).T
            square = value.size * nu / (nu - 2) + common.sum() ** 2 - np.square(common).sum()
            degrees = 4 + 4 * value.size
            z = abs(value.sum()) * np.sqrt(degrees / (degrees - 2) / square)
            *_, run, row = max(rows, key=lambda each: each[0] * np.sign(value.sum()))
            size = float(runs[run].size[row])
            if size > relevance:
                p_value = -np.expm1(len(places) * np.log1p(-min(2 * float(t.sf(z, degrees)), 1 - 1e-16)))
                found.append(Excess(f"mean of {_KINDS[kind]}", float(p_value), run, kind, row, size))
        yield from sorted(found, key=lambda one: one.p_value)[:1]


def _place_of(seen: RunFeatures, kind: int, at: int) -> tuple[str, float]:
    if kind == BAND:
        return "", round(float(seen.bands.middle[at]), 3)
    return seen.places[at].domain, seen.places[at].at


def _sum_of(runs: Sequence[JudgedRun], kinds: tuple[int, ...], relevance: float, largest: Excess) -> Excess:
    """Return the sum of the deviances of some kinds; it counts where their joint error exceeds the relevance.

    Neighbouring features have errors in common. The variance of the sum is that of independent ones, or what the
    scatter of the sums over the segments of all runs gives where that is larger (Huber 1967, 5th Berkeley Symp. 1:
    variance under clustering).
    """
    from scipy.stats import norm

    nu, (mean, variance) = DEGREES_OF_FREEDOM, deviance_moments()
    groups = [
        (nu + 1) * np.log1p(own**2 / nu) - mean
        for each in runs for kind in kinds for own in _by_segment(each.residuals, kind)
    ]  # fmt: skip
    sums, counts = np.array([each.sum() for each in groups]), np.array([each.size for each in groups])
    total, count = float(sums.sum()), float(counts.sum())
    square = count * variance
    if count and sums.size > 1:
        between = float(np.square(sums - counts * total / count).sum())
        square = max(square, between * sums.size / (sums.size - 1))
    beyond = max(sum(each.excess[kind] for kind in kinds) for each in runs)
    p_value = float(norm.sf(total / np.sqrt(square))) if beyond > relevance**2 else 1.0
    name = _KINDS[kinds[0]] if len(kinds) == 1 else "all"
    return replace(largest, statistic=f"sum of {name}", p_value=p_value)


def _by_segment(each: Residuals, kind: int) -> Iterator[Floats]:
    """Yield the standardised residuals of one kind in each segment; mean torques of a run are one group."""
    own = each.kind == kind
    for segment in np.unique(each.segment[own]).tolist():
        yield each.standardised[own & (each.segment == segment)]


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


def _sizes(seen: RunFeatures, each: Residuals) -> tuple[Floats, Floats, Floats]:
    """Return how large what is left is in the reading, its mean square, and the one that is to be expected.

    The first is the rms [N m] of an uncorrelated effect that makes the difference of the powers. The mean squares
    [(N m)^2] are of the least difference of two processes, ``(sqrt P - sqrt M)^2`` (Gelbrich 1990, Math. Nachr. 147),
    the last one for residuals of their standard deviation. Shape (features,) each.
    """
    power = np.zeros(each.value.size)
    line, band, level = each.kind == LINE, each.kind == BAND, each.kind == LEVEL
    power[line] = 0.5 * seen.lines.power[each.segment[line], each.at[line]]
    width = (seen.bands.high - seen.bands.low)[each.at[band]]
    power[band] = width * seen.band_power[each.segment[band], each.at[band]]
    size = np.sqrt(power * np.abs(-np.expm1(-each.value)))
    square = power * np.expm1(-0.5 * each.value) ** 2
    permitted = power * np.exp(-each.value) * np.expm1(0.5 * each.sd) ** 2
    size[level] = seen.largest_level * np.abs(each.value[level])
    square[level], permitted[level] = size[level] ** 2, (seen.largest_level * each.sd[level]) ** 2
    return size, square, permitted
