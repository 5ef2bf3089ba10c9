"""All that is looked at in one channel, for a stretch; two stretches join to one."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil, log2

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.inspection.course import COLUMNS, Course, course_of, joined_courses, thinned
from torquerig.recordings.inspection.extremes import Extreme, extreme_of, joined_extremes
from torquerig.recordings.inspection.histogram import Histogram, histogram_of, joined_histograms
from torquerig.recordings.inspection.levels import Levels, joined_levels, levels_of
from torquerig.recordings.inspection.mean_power import SEGMENT, MeanPower, joined_powers, mean_power_of
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
"""A dropout lasts this long at most [s]; what lasts longer is a level of the signal."""


@dataclass(frozen=True, kw_only=True)
class Look:
    """What a stretch of a channel holds; ``spikes`` and ``dropouts`` count those beyond the first thousand too."""

    levels: Levels
    gone: tuple[Run, ...]
    repeats: Repeats
    high: Extreme | None
    low: Extreme | None
    spikes: tuple[int, ...]
    dropouts: tuple[Run, ...]
    histogram: Histogram | None
    course: Course
    power: MeanPower


def look_at(
    values: NDArray[np.float64], kept: slice, *, first: int, rate: float, judged: bool, before: Look | None = None
) -> Look:
    """Return what ``values[kept]`` holds.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        A stretch with its neighbours, which help to judge the samples at its ends.
    kept : slice
        What the answer is about.
    first : int
        The number of the first kept sample in the recording.
    rate : float
        [Hz].
    judged : bool
        Whether spikes and dropouts are looked for; an angle may jump.
    before : Look, optional
        Of an earlier stretch, with which the answer is to be joined.
    """
    own = values[kept]
    gone = not_numbers(own, first)
    finite = own[np.isfinite(own)] if gone else own
    width = before.course.width if before else 2 ** max(ceil(log2(max(own.size, 1) / COLUMNS)), 0)
    segment = before.power.segment if before else min(SEGMENT, own.size)
    spikes, dropouts = _outliers(values, kept, first=first, rate=rate) if judged else ((), ())
    return Look(
        levels=levels_of(own),
        gone=gone,
        repeats=repeats_of(own, first),
        high=extreme_of(finite) if finite.size else None,
        low=extreme_of(-finite) if finite.size else None,
        spikes=spikes,
        dropouts=dropouts,
        histogram=histogram_of(finite),
        course=thinned(course_of(own, width=width)),
        # a straight line where no numbers stand, so that one lost sample does not cost the spectrum
        power=mean_power_of(_bridged(own) if gone else own, segment=segment),
    )


def joined_looks(left: Look, right: Look) -> Look:
    """Return what two stretches that follow each other hold together."""
    return Look(
        levels=joined_levels(left.levels, right.levels),
        gone=joined_runs(left.gone, right.gone),
        repeats=joined_repeats(left.repeats, right.repeats),
        high=_outer(left.high, right.high),
        low=_outer(left.low, right.low),
        spikes=(*left.spikes, *right.spikes)[:KEPT],
        dropouts=(*left.dropouts, *right.dropouts)[:KEPT],
        histogram=joined_histograms(left.histogram, right.histogram),
        course=joined_courses(left.course, right.course),
        power=joined_powers(left.power, right.power),
    )


def _outer(left: Extreme | None, right: Extreme | None) -> Extreme | None:
    return left or right if left is None or right is None else joined_extremes(left, right)


def _outliers(
    values: NDArray[np.float64], kept: slice, *, first: int, rate: float
) -> tuple[tuple[int, ...], tuple[Run, ...]]:
    """Spikes and dropouts that begin among the kept samples, numbered as in the recording."""
    whole = _bridged(values)
    if whole.size == 0:
        return (), ()
    start, stop = kept.start or 0, values.size if kept.stop is None else kept.stop
    shift = first - start
    dropouts = dropouts_in(whole, longest=max(round(LONGEST_DROPOUT * rate), 4))
    # a dropout of three samples also looks like spikes
    inside = {sample for run in dropouts for sample in range(run.first - 1, run.last + 2)}
    spikes = [one for one in spikes_in(whole) if one not in inside]
    return (
        tuple(one + shift for one in spikes if start <= one < stop),
        tuple(replace(run, first=run.first + shift) for run in dropouts if start <= run.first < stop),
    )


def _bridged(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return ``values`` with straight lines where no numbers stand; nothing where no number stands at all."""
    good = np.isfinite(values)
    if good.all():
        return values
    places = np.flatnonzero(good)
    if places.size == 0:
        return np.empty(0)
    return np.asarray(np.interp(np.arange(values.size), places, values[places]))
