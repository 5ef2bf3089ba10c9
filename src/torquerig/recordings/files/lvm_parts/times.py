"""The sample rate of an LVM channel: Delta_X of the header against the printed X values."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.timing import shortest_rate
from torquerig.recordings.names.channel_units import unit_meanings

# largest deviation of an X value from the even grid [samples]; one lost sample makes half a sample or more
_UNEVEN = 0.25


@dataclass(frozen=True, kw_only=True)
class Sampling:
    """The rate of a channel [Hz] (0 where it is not known), a sentence, and whether the X values must be kept."""

    rate: float
    note: str = ""
    keep_times: bool = False


@np.errstate(all="ignore")
def sampling(times: NDArray[np.float64] | None, increment: float, *, decimals: int) -> Sampling:
    """Return the sampling of a channel from its X values [s] and its ``Delta_X`` [s].

    X values that rise evenly determine the rate, because LabVIEW writes Delta_X = 1 where it does not know it. X
    values that lie on the grid of Delta_X, up to the last printed digit, confirm it. Uneven X values are kept as times.

    Parameters
    ----------
    times : ndarray, shape (samples,), or None
        The printed X values [s]; None where the file has none.
    increment : float
        Delta_X [s]; 0 where the file does not state it.
    decimals : int
        Decimal places of the printed X values.
    """
    stated = shortest_rate(1 / increment, tolerance=1e-11) if increment > 0 else 0.0
    if times is None or times.size < 2:
        return Sampling(rate=stated)
    printed = 0.6 * 10.0 ** -min(decimals, 300)
    if stated and _off_grid(times, increment) <= max(_UNEVEN * increment, printed):
        return Sampling(rate=stated)
    step = float(times[-1] - times[0]) / (times.size - 1)
    worst = _off_grid(times, step)
    if np.all(np.diff(times) > 0) and worst <= max(_UNEVEN * step, printed):
        rate = shortest_rate(1 / step, tolerance=max(1e-11, 2 * worst / (step * (times.size - 1))))
        note = f"X_Value rises by {1 / rate:.6g} s and Delta_X states {increment:.6g} s; X_Value is used"
        return Sampling(rate=rate, note=note if stated else "")
    usual = float(np.median(np.diff(times)))
    if stated and abs(usual - increment) > max(_UNEVEN * increment, 2 * printed):
        note = f"X_Value rises unevenly, by {usual:.6g} s in the median; Delta_X = {increment:.6g} s is not used"
        return Sampling(rate=0.0, note=note, keep_times=True)
    return Sampling(rate=stated, keep_times=True)


def _off_grid(times: NDArray[np.float64], step: float) -> float:
    """Return the largest deviation of ``times`` from an even grid of ``step`` that begins with the first [s]."""
    off = times - times[0] - step * np.arange(times.size)
    with np.errstate(invalid="ignore"):
        return float(np.max(np.abs(off)))


def seconds_of(unit: str) -> float | None:
    """Return the length of an X unit [s]; a blank unit is the second, another than one of time is None."""
    if not unit.strip():
        return 1.0
    return next((meaning.factor for meaning in unit_meanings(unit.strip()) if meaning.kind == "time"), None)
