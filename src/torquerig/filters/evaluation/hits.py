"""The largest hits of a known load, and how high and how steep a reading shows them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.filters.evaluation.rise import rise_time

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

MOST = 40  # hits that are looked at
_STEEP = 2e-3  # [s] a hit is what the load gains within this time
_APART = 30e-3  # [s] from one hit to the next
_BEFORE, _AFTER, _EARLY = 8e-3, 15e-3, 2e-3  # [s] level before; how long the load and the reading take to their peak
_STANDS_OUT = 2.0  # rms of all gains by which a hit must exceed 0


@dataclass(frozen=True, kw_only=True)
class HitsShown:
    """How a reading shows the largest hits of the load.

    Parameters
    ----------
    count : int
        Hits that were looked at.
    height : float
        Median height of the hits in the load [N m].
    peak : float
        Median of peak height in the reading over that in the load [1]; 1 is true to the load.
    peak_low, peak_high : float
        The tenth and the ninetieth of a hundred.
    rise, true_rise : float
        Median time from 10 % to 90 % of the peak, in the reading and in the load [s].
    """

    count: int
    height: float
    peak: float
    peak_low: float
    peak_high: float
    rise: float
    true_rise: float


def hits_of(load: Floats, rate: float) -> NDArray[np.int64]:
    """Return the samples at which the largest hits of a load begin, in order of time; empty for a smooth load.

    A hit is a gain within 2 ms of more than twice the rms of all gains, 30 ms or more from a larger one; at most 40.
    """
    step = max(round(_STEEP * rate), 1)
    apart, room = round(_APART * rate), round((_BEFORE + _EARLY) * rate)
    gains = load[step:] - load[:-step]
    if gains.size == 0 or not gains.std() > 0:
        return np.empty(0, dtype=np.int64)
    steep = np.flatnonzero(gains > _STANDS_OUT * float(np.sqrt(np.mean(gains**2))))
    found: list[int] = []
    for place in steep[np.argsort(-gains[steep], kind="stable")]:
        if room <= place < load.size - apart and all(abs(place - one) >= apart for one in found):
            found.append(int(place))
            if len(found) == MOST:
                break
    return np.array(sorted(found), dtype=np.int64)


def hits_shown(reading: Floats, load: Floats, *, rate: float, delay: float = 0.0) -> HitsShown | None:
    """Return how ``reading`` shows the hits of ``load``, or None where the load has fewer than three.

    Parameters
    ----------
    reading, load : ndarray, shape (samples,)
        [N m].
    rate : float
        [Hz].
    delay : float
        By how much the reading comes later [s]; the windows are moved by it.

    Notes
    -----
    Both are counted from their own level in the 8 ms before the hit. The windows overlap what is left of lines, so
    that a line of half the hit's height shows in peak and rise: that is what the reader of the curve sees too.
    """
    begins = hits_of(load, rate)
    shown = [_one(reading, load, int(begin), rate, round(delay * rate)) for begin in begins]
    kept = np.array([one for one in shown if one is not None])
    if len(kept) < 3:
        return None
    height, peak, true_rise, rise = kept.T
    low, high = np.percentile(peak / height, [10, 90])
    return HitsShown(
        count=len(kept),
        height=float(np.median(height)),
        peak=float(np.median(peak / height)),
        peak_low=float(low),
        peak_high=float(high),
        rise=float(np.median(rise)),
        true_rise=float(np.median(true_rise)),
    )


def _one(reading: Floats, load: Floats, begin: int, rate: float, late: int) -> tuple[float, float, float, float] | None:
    """Height in load and reading, rise in load and reading, of the hit at ``begin``."""
    before, after, early = (round(time * rate) for time in (_BEFORE, _AFTER, _EARLY))
    true = load[begin : begin + after] - load[begin - before : begin].mean()
    start = begin + late
    if start - before - early < 0 or start + after > reading.size or not true.max() > 0:
        return None
    seen = reading[start - early : start + after] - reading[start - before - early : start - early].mean()
    return float(true.max()), float(seen.max()), rise_time(true, rate), rise_time(seen, rate)
