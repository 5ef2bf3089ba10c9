"""The largest hits of a known load, and their peak and rise time in a reading."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.filters.evaluation.load_scale import WEAR_PART
from torquerig.filters.evaluation.rise import rise_time

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

MOST = 40  # largest number of hits
# in decay times of a hit:
_STEEP = 0.5  # time over which the increase of the load is taken
_APART = 7.5  # least distance of two hits
_BEFORE, _AFTER, _EARLY = 2.0, 3.75, 0.5  # window of the level before, of the peak, and before the reading
_LEAST_GAIN = 2.0  # [1] least increase of a hit, in rms of all increases


@dataclass(frozen=True, kw_only=True)
class HitResponse:
    """Peak and rise time of the largest hits of the load in a reading.

    Parameters
    ----------
    count : int
        Number of hits.
    height : float
        Median height of the hits in the load [N m].
    peak : float
        Median ratio of the peak height in the reading to that in the load [1]; 1 is ideal.
    peak_low, peak_high : float
        The 10th and 90th percentile of this ratio [1].
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


def hits_of(load: Floats, rate: float, *, decay: float = WEAR_PART.hit_decay) -> NDArray[np.int64]:
    """Return the samples at which the largest hits of a load begin, in order of time; empty for a smooth load.

    A hit is a gain within half the ``decay`` [s] of more than twice the rms of all gains, 7.5 decays or more from a
    larger one; at most 40.
    """
    step = max(round(_STEEP * decay * rate), 1)
    apart, lead = round(_APART * decay * rate), round((_BEFORE + _EARLY) * decay * rate)
    gains = load[step:] - load[:-step]
    if gains.size == 0 or not gains.std() > 0:
        return np.empty(0, dtype=np.int64)
    steep = np.flatnonzero(gains > _LEAST_GAIN * float(np.sqrt(np.mean(gains**2))))
    found: list[int] = []
    for place in steep[np.argsort(-gains[steep], kind="stable")]:
        if lead <= place < load.size - apart and all(abs(place - one) >= apart for one in found):
            found.append(int(place))
            if len(found) == MOST:
                break
    return np.array(sorted(found), dtype=np.int64)


def hit_response(
    reading: Floats, load: Floats, *, rate: float, delay: float = 0.0, decay: float = WEAR_PART.hit_decay
) -> HitResponse | None:
    """Return peak and rise time of the hits of ``load`` in ``reading``, or None with fewer than three hits.

    Parameters
    ----------
    reading, load : ndarray, shape (samples,)
        [N m].
    rate : float
        [Hz].
    delay : float
        Delay of the reading [s]; the windows are shifted by it.
    decay : float
        Decay time of a hit [s], of which all windows are multiples.

    Notes
    -----
    Heights are relative to the mean level in the two decay times before the hit. Remaining lines are not removed from
    the windows, so that a line of half the hit's height changes peak and rise, as it does in a plot.
    """
    if load.size and load.mean() < 0:  # a load of the other sign hits the other way
        reading, load = -reading, -load
    begins = hits_of(load, rate, decay=decay)
    shown = [_one(reading, load, int(begin), rate, late=round(delay * rate), decay=decay) for begin in begins]
    kept = np.array([one for one in shown if one is not None])
    if len(kept) < 3:
        return None
    height, peak, true_rise, rise = kept.T
    low, high = np.percentile(peak / height, [10, 90])
    return HitResponse(
        count=len(kept),
        height=float(np.median(height)),
        peak=float(np.median(peak / height)),
        peak_low=float(low),
        peak_high=float(high),
        rise=float(np.median(rise)),
        true_rise=float(np.median(true_rise)),
    )


def _one(
    reading: Floats, load: Floats, begin: int, rate: float, *, late: int, decay: float
) -> tuple[float, float, float, float] | None:
    """Return height in load and reading, and rise time in load and reading, of the hit at ``begin``."""
    before, after, early = (round(time * decay * rate) for time in (_BEFORE, _AFTER, _EARLY))
    true = load[begin : begin + after] - load[begin - before : begin].mean()
    start = begin + late
    if start - before - early < 0 or start + after > reading.size or not true.max() > 0:
        return None
    seen = reading[start - early : start + after] - reading[start - before - early : start - early].mean()
    return float(true.max()), float(seen.max()), rise_time(true, rate), rise_time(seen, rate)
