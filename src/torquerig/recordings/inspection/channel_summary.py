"""The summary of one channel over a block: levels, runs, extremes, outliers, histogram, spectrum; blocks are joined."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil, log2

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.inspection.extremes import Extreme, extreme_of, joined_extremes
from torquerig.recordings.inspection.histogram import Histogram, histogram_of, joined_histograms
from torquerig.recordings.inspection.levels import Levels, joined_levels, levels_of
from torquerig.recordings.inspection.mean_power import SEGMENT, MeanPower, joined_powers, mean_power_of
from torquerig.recordings.inspection.min_max_envelope import (
    COLUMNS,
    MinMaxEnvelope,
    envelope_of,
    joined_envelopes,
    thinned,
)
from torquerig.recordings.inspection.outliers import dropouts_in, spikes_in
from torquerig.recordings.inspection.runs import (
    KEPT,
    Repeats,
    Run,
    joined_repeats,
    joined_runs,
    not_numbers,
    repeats_of,
)

LONGEST_DROPOUT = 0.1
"""Longest dropout [s]; a longer stretch is a level of the signal."""


@dataclass(frozen=True, kw_only=True)
class ChannelSummary:
    """The summary of a block of one channel; of each kind of finding the first thousand are kept."""

    levels: Levels
    gone: tuple[Run, ...]
    repeats: Repeats
    high: Extreme | None
    low: Extreme | None
    spikes: tuple[int, ...]
    dropouts: tuple[Run, ...]
    histogram: Histogram | None
    envelope: MinMaxEnvelope
    power: MeanPower


def summarise(
    values: NDArray[np.float64],
    kept: slice,
    *,
    first: int,
    rate: float,
    judged: bool,
    before: ChannelSummary | None = None,
) -> ChannelSummary:
    """Return the summary of ``values[kept]``.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        A block with its overlap, which is needed to find outliers near its ends.
    kept : slice
        The block without the overlap.
    first : int
        The number of the first kept sample in the recording.
    rate : float
        [Hz].
    judged : bool
        Whether spikes and dropouts are searched; False for an angle, which may jump.
    before : ChannelSummary, optional
        Of an earlier block, with which the result will be joined.
    """
    inner = values[kept]
    gone = not_numbers(inner, first)
    finite = inner[np.isfinite(inner)] if gone else inner
    width = before.envelope.width if before else 2 ** max(ceil(log2(max(inner.size, 1) / COLUMNS)), 0)
    segment = before.power.segment if before else min(SEGMENT, inner.size)
    spikes, dropouts = _outliers(values, kept, first=first, rate=rate) if judged else ((), ())
    return ChannelSummary(
        levels=levels_of(inner),
        gone=gone,
        repeats=repeats_of(inner, first),
        high=extreme_of(finite) if finite.size else None,
        low=extreme_of(-finite) if finite.size else None,
        spikes=spikes,
        dropouts=dropouts,
        histogram=histogram_of(finite),
        envelope=thinned(envelope_of(inner, width=width)),
        # interpolated over missing numbers, so that one lost sample does not remove a segment
        power=mean_power_of(_interpolated(inner) if gone else inner, segment=segment),
    )


def joined_summaries(left: ChannelSummary, right: ChannelSummary) -> ChannelSummary:
    """Return the summary of two consecutive blocks together."""
    return ChannelSummary(
        levels=joined_levels(left.levels, right.levels),
        gone=joined_runs(left.gone, right.gone),
        repeats=joined_repeats(left.repeats, right.repeats),
        high=_outer(left.high, right.high),
        low=_outer(left.low, right.low),
        spikes=(*left.spikes, *right.spikes)[:KEPT],
        dropouts=(*left.dropouts, *right.dropouts)[:KEPT],
        histogram=joined_histograms(left.histogram, right.histogram),
        envelope=joined_envelopes(left.envelope, right.envelope),
        power=joined_powers(left.power, right.power),
    )


def _outer(left: Extreme | None, right: Extreme | None) -> Extreme | None:
    return left or right if left is None or right is None else joined_extremes(left, right)


def _outliers(
    values: NDArray[np.float64], kept: slice, *, first: int, rate: float
) -> tuple[tuple[int, ...], tuple[Run, ...]]:
    """Return the spikes and dropouts that begin among the kept samples, numbered as in the recording."""
    whole = _interpolated(values)
    if whole.size == 0:
        return (), ()
    start, stop = kept.start or 0, values.size if kept.stop is None else kept.stop
    shift = first - start
    dropouts = dropouts_in(whole, longest=max(round(LONGEST_DROPOUT * rate), 4))
    # the edges of a short dropout are also found as spikes
    inside = {sample for run in dropouts for sample in range(run.first - 1, run.last + 2)}
    spikes = [one for one in spikes_in(whole) if one not in inside]
    return (
        tuple(one + shift for one in spikes if start <= one < stop),
        tuple(replace(run, first=run.first + shift) for run in dropouts if start <= run.first < stop),
    )


def _interpolated(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return ``values`` with missing numbers interpolated linearly; empty where there is no number at all."""
    good = np.isfinite(values)
    if good.all():
        return values
    places = np.flatnonzero(good)
    if places.size == 0:
        return np.empty(0)
    return np.asarray(np.interp(np.arange(values.size), places, values[places]))
