"""Random telegraph (burst, popcorn) noise: a zero that jumps to and fro between two levels, in all runs by one height.

A jump that takes a few samples stands out of the signal's differences over so many samples long before it stands out of
the signal, for loads and shafts take their time. Blows and bursts do so too, but come back at once: a jump stays. Where
a bearing rings so that its differences are as clear, a jump within a sample still stands alone among those beside it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.edges import differences_over, edges_over, largest_of_each, stays_so
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, amount, fault_in_time, in_words
from torquerig.recordings.repair.moments import Moments
from torquerig.recordings.repair.robust_spread import spread_about_median, spread_about_zero
from torquerig.recordings.repair.sample_jumps import sample_jumps

Floats = NDArray[np.float64]

_LAGS, _SLOWEST = (1, 2, 4, 8, 16), 0.001  # samples and [s] that a jump may take: a load takes longer
_FASTEST = 5e-4  # [s] between samples: where more passes, a drive's torque jumps from one sample to the next too
_CLEAR = 8.0  # robust spreads of the differences, or codes
_ALIKE = 0.1  # of the height: spread of what is one height
# of the spread of the heights: ends that scatter less are one level, to which a signal is lost; more is asked of jumps
# that stand alone, which need not stay
_RATHER_A_LEVEL, _OF_THOSE_ALONE = 0.5, 1.0
# jumps over all runs, and runs, or halves of a single one, with any: fewer are steps of the mean, as a load makes them
_FEWEST, _RUNS = 6, 2
_SHARP = 3  # jumps within a sample: then nothing rounds them, and those that are no telegraph noise stay none
_GROWS = 1.1  # times the height that edges over twice the samples have: then the jumps take longer
_TRUE_ONES, _TO_AND_FRO = 0.8, 0.9  # of what is clear stays; of what stays follows one of the other sign


@dataclass(frozen=True)
class Telegraph:
    """Levels ``height`` [V] apart, between which the signal jumps within ``lag`` samples, ``clear`` spreads of such.

    ``jumps`` are the first samples of each new level in one recording, ``up`` whether the first of them goes up.
    """

    height: float
    clear: float
    lag: int
    jumps: tuple[int, ...]
    up: bool

    def level(self, samples: int) -> Floats:
        """Return by how much the signal stands above the lower of its levels [V], shape (samples,)."""
        flips = np.zeros(samples)
        flips[list(self.jumps)] = 1.0
        return np.asarray(self.height * ((np.cumsum(flips) + (not self.up)) % 2))


@dataclass(frozen=True)
class _Jumps:
    """First samples of new levels, heights and lower ends [V], how many differences were clear, of what spread [V].

    ``samples`` are those of the recording.
    """

    at: NDArray[np.int64]
    heights: Floats
    lower: Floats
    clear: int
    spread: float
    samples: int

    @property
    def halves(self) -> int:
        """How many halves of the recording hold jumps."""
        return int(np.unique(2 * self.at // self.samples).size)


def one_level(seen: Examination) -> Examination:
    """Remove telegraph noise."""
    levels = telegraph_noise(seen.recordings, seen.lost, resolution=2 * seen.resolution)
    told = [_fault(each, own) for each, own in zip(seen.recordings, levels, strict=True) if own is not None]
    level = without_telegraph(seen.recordings, levels)
    lost = tuple([*some, *more] for some, more in zip(seen.lost, level.moments, strict=True))
    stepping = seen.stepping or any(level.to_the_other)
    return replace(
        seen, recordings=level.recordings, lost=lost, to_the_other=level.to_the_other, stepping=stepping
    ).with_faults(*told)


def _fault(recording: Recording, own: Telegraph) -> Fault:
    rate, samples = recording.sample_rate, "a sample" if own.lag == 1 else f"{own.lag} samples"
    stop = own.jumps[1] if len(own.jumps) > 1 else recording.samples
    return fault_in_time(
        recording, "telegraph noise", own.jumps[0], stop, excess=20 * float(np.log10(own.clear)),
        seen=f"at {in_words([at / rate for at in own.jumps])} the signal jumps to and fro between two levels "
        f"{amount(recording, own.height)} apart, within {samples}; no torque does that, random telegraph (burst) noise "
        "of an amplifier or a loose contact does",
        repair="no mechanism of the library does that: the rest was judged at one level",
    )  # fmt: skip


def telegraph_noise(
    recordings: Sequence[Recording], lost: Sequence[Moments], *, resolution: float
) -> tuple[Telegraph | None, ...]:
    """Return the telegraph noise of each recording; None in all where there is none.

    Parameters
    ----------
    recordings : sequence of Recording
        Moments without signal bridged.
    lost : sequence of Moments
        Those moments of each, whose ends are no jumps.
    resolution : float
        One code [V]: a signal that rests on a code steps to the next and back.
    """
    volts = [recording.torque_values() for recording in recordings]
    rates = [recording.sample_rate for recording in recordings]
    looks = [*zip(volts, rates, lost, strict=True)]
    lags = [lag for lag in _LAGS if lag <= _SLOWEST * min(rates)]
    each_lag = [_one_telegraph([_jumps(*look, lag=lag, resolution=resolution) for look in looks], lag) for lag in lags]
    if _FASTEST * min(rates) < 1:
        return (None,) * len(volts)
    alone = [_alone(own, without, resolution=resolution) for own, without in zip(volts, lost, strict=True)]
    each_lag.append(_one_telegraph(alone, 1, level=_OF_THOSE_ALONE))
    found = max(each_lag, key=_least_clear)
    if not any(found) and sum(each.at.size for each in alone) < _SHARP:
        rounded = [[_rounded_jumps(*look, lag=lag, resolution=resolution) for look in looks] for lag in lags]
        each_lag = [_one_telegraph(each, lag) for each, lag in zip(rounded, lags, strict=True)]
        found = max(each_lag, key=_least_clear)
    return _whole_edges(found, volts, max(lags))


def _whole_edges(
    found: tuple[Telegraph | None, ...], volts: Sequence[Floats], longest: int
) -> tuple[Telegraph | None, ...]:
    """Return the same with the height and the length of edges that go on beyond the samples that showed them."""
    known = [(own, each) for own, each in zip(found, volts, strict=True) if own is not None]
    if not known:
        return found
    lag, height = known[0][0].lag, known[0][0].height
    for longer in (2 * lag, 4 * lag, 8 * lag):
        at = [np.array(own.jumps) - lag // 2 - longer // 2 - lag % 2 for own, _ in known]
        edges = [edges_over(each, longer) for _, each in known]
        sizes = np.concatenate([np.abs(own[np.clip(one, 0, own.size - 1)]) for own, one in zip(edges, at, strict=True)])
        if longer > 2 * longest or float(np.median(sizes)) < _GROWS * height:
            break
        known = [
            (replace(own, lag=longer, jumps=_later(own.jumps, (longer - lag) // 2, each.size)), each)
            for own, each in known
        ]
        lag, height = longer, float(np.median(sizes))
    grown = iter(own for own, _ in known)
    return tuple(None if own is None else replace(next(grown), height=height) for own in found)


def _later(jumps: Sequence[int], samples: int, end: int) -> tuple[int, ...]:
    return tuple(min(at + samples, end - 1) for at in jumps)


def _least_clear(told: Sequence[Telegraph | None]) -> float:
    return min((own.clear for own in told if own is not None), default=0.0)


@dataclass(frozen=True)
class OneLevel:
    """Recordings at one level, the moments in which each is on its way to another, and what leads to the other [V].

    The last, to be added to every value of a recording, is 0 where that never jumps.
    """

    recordings: tuple[Recording, ...]
    moments: tuple[Moments, ...]
    to_the_other: tuple[float, ...]


def without_telegraph(recordings: Sequence[Recording], found: Sequence[Telegraph | None]) -> OneLevel:
    """Return the recordings at one level.

    Which of the two is the zero the samples do not tell: the one taken brings the mean of the emptiest run nearest to
    none, for idle shafts need little torque and such as turn back need none on average. A model may tell better.
    """
    each = [_at_lower(recording, own) for recording, own in zip(recordings, found, strict=True)]
    jumping = [(recording, volts) for recording, volts, own in zip(recordings, each, found, strict=True) if own]
    emptiest = min((_load(recording) for recording, _ in jumping), default=0.0)
    means = np.array([volts.mean() for recording, volts in jumping if _load(recording) == emptiest])
    height = next((own.height for own in found if own is not None), 0.0)
    zero = height if means.size and np.abs(means + height).min() < np.abs(means).min() else 0.0
    mended, moments = list(recordings), list[Moments]()
    for index, (recording, own) in enumerate(zip(recordings, found, strict=True)):
        moments.append([] if own is None or own.lag == 1 else [(at - own.lag, at) for at in own.jumps])
        if own is not None:
            mended[index] = recording.with_values(recording.torque_name(), each[index] + zero)
    other = tuple(0.0 if own is None else height - 2 * zero for own in found)
    return OneLevel(tuple(mended), tuple(moments), other)


def _load(recording: Recording) -> float:
    return recording.run.occupancy_percent or 0.0


def _at_lower(recording: Recording, own: Telegraph | None) -> Floats:
    volts = recording.torque_values()
    return volts if own is None else volts - own.level(volts.size)


def _jumps(volts: Floats, rate: float, lost: Moments, *, lag: int, resolution: float) -> _Jumps:
    """Return the clear differences over so many samples that stay."""
    differences = differences_over(volts, lag)
    return _staying(volts, rate, lost, differences, differences, lag=lag, resolution=resolution)


def _rounded_jumps(volts: Floats, rate: float, lost: Moments, *, lag: int, resolution: float) -> _Jumps:
    """Return the same by the edges, which are clear where a signal that moves evenly wanders by as much."""
    edges, differences = edges_over(volts, lag), differences_over(volts, lag)
    found = _staying(volts, rate, lost, edges, differences, lag=lag, resolution=resolution)
    return replace(found, heights=edges[found.at - lag])


def _staying(
    volts: Floats, rate: float, lost: Moments, edges: Floats, differences: Floats, *, lag: int, resolution: float
) -> _Jumps:
    """Return where the ``edges`` are clear and the ``differences`` over so many samples stay."""
    spread = max(spread_about_zero(edges), resolution, 1e-12)
    sizes = np.abs(edges)
    clear = sizes > _CLEAR * spread
    for start, stop in lost:
        clear[max(start - 2 * lag, 0) : stop + lag] = False
    at = largest_of_each(sizes, np.flatnonzero(clear), apart=4 * lag)
    stays = stays_so(volts, rate, at, differences[at], lag=lag)
    at, clear_ones = at[stays], at.size
    lower = np.minimum(volts[at], volts[at + lag])
    return _Jumps(at + lag, differences[at], lower, clear_ones, spread, volts.size)


def _alone(volts: Floats, lost: Moments, *, resolution: float) -> _Jumps:
    """Return the jumps from one sample to the next that stand alone."""
    at, spread = sample_jumps(volts, lost, resolution=resolution), spread_about_zero(np.diff(volts))
    lower = np.minimum(volts[at], volts[at - 1])
    return _Jumps(at, volts[at] - volts[at - 1], lower, at.size, max(spread, resolution, 1e-12), volts.size)


def _one_telegraph(
    found: Sequence[_Jumps], lag: int, *, level: float = _RATHER_A_LEVEL
) -> tuple[Telegraph | None, ...]:
    """Return the telegraph noise that the jumps of all runs make, None in all where they make none."""
    none = (None,) * len(found)
    heights = np.concatenate([each.heights for each in found])
    clear = sum(each.clear for each in found)
    parts = found[0].halves if len(found) == 1 else sum(each.at.size > 0 for each in found)
    if heights.size < max(_FEWEST, _TRUE_ONES * clear) or parts < _RUNS:
        return none
    height = float(np.median(np.abs(heights)))
    follows = sum(int(np.sum(each.heights[1:] * each.heights[:-1] < 0)) for each in found)
    pairs = sum(max(each.at.size - 1, 0) for each in found)
    lower = np.concatenate([each.lower for each in found])
    if spread_about_zero(np.abs(heights) - height) > _ALIKE * height or follows < _TO_AND_FRO * pairs:
        return none
    if min(spread_about_median(lower), spread_about_median(lower + np.abs(heights))) < level * spread_about_median(
        np.abs(heights)
    ):
        return none
    return tuple(_alternating(each, height, lag) for each in found)


def _alternating(found: _Jumps, height: float, lag: int) -> Telegraph | None:
    """Return the jumps of about this height; of two that go the same way the one that is more like it."""
    kept: list[int] = []
    apart = np.abs(np.abs(found.heights) - height)
    for index in np.flatnonzero(apart < 0.5 * height).tolist():
        if kept and found.heights[kept[-1]] * found.heights[index] > 0:
            kept[-1] = min(kept[-1], index, key=lambda one: float(apart[one]))
        else:
            kept.append(index)
    if not kept:
        return None
    first_up = bool(found.heights[kept[0]] > 0)
    return Telegraph(height, height / found.spread, lag, tuple(found.at[kept].tolist()), first_up)
