"""The shift between two files of one run, by a channel that both have."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError

_LEAST_CORRELATION = 0.7  # below it, less than half of the power is common
_NEXT_BEST = 0.95  # of the highest correlation: a second peak as high makes the shift ambiguous


@dataclass(frozen=True)
class Shift:
    """The second file begins ``seconds`` after the first; ``correlation`` of the common channel there."""

    seconds: float
    correlation: float


def shift_between(first: NDArray[np.float64], second: NDArray[np.float64], *, rate: float, name: str) -> Shift:
    """Return the shift at which two readings of one signal agree best.

    Parameters
    ----------
    first, second : ndarray, shape (n,) and (m,)
        The common channel in both files, at one ``rate`` [Hz].
    name : str
        The channel, for messages.

    Raises
    ------
    RecordingError
        Where the channel is constant, the best correlation is below 0.7, or a periodic signal agrees equally well at
        another shift.

    The correlation at each shift is that of the overlapping samples, of at least a tenth of the shorter file; between
    two samples the shift is that of the parabola through three of them.
    """
    coefficient, lags = _correlation(first - first.mean(), second - second.mean())
    if coefficient is None:
        raise RecordingError(f"{name} is constant in one of the files; align by another channel, or by --align start")
    best = int(np.argmax(coefficient))
    top = float(coefficient[best])
    if top < _LEAST_CORRELATION:
        raise RecordingError(
            f"the two readings of {name} agree nowhere (the best correlation is {top:.2f}); align by another channel"
        )
    left = best
    while left > 0 and coefficient[left - 1] < coefficient[left]:
        left -= 1
    right = best
    while right < coefficient.size - 1 and coefficient[right + 1] < coefficient[right]:
        right += 1
    others = np.concatenate([coefficient[:left], coefficient[right + 1 :]])
    if others.size and others.max() > _NEXT_BEST * top:
        places = np.concatenate([lags[:left], lags[right + 1 :]])
        other = places[int(others.argmax())]
        raise RecordingError(
            f"{name} repeats itself: shifts of {lags[best] / rate:.6g} s and {other / rate:.6g} s fit equally well; "
            "align by a channel that does not repeat, or by --align clock"
        )
    return Shift(seconds=(lags[best] + _between(coefficient, best)) / rate, correlation=min(top, 1.0))


def _correlation(
    first: NDArray[np.float64], second: NDArray[np.float64]
) -> tuple[NDArray[np.float64] | None, NDArray[np.int64]]:
    """Return the correlation of the overlap at each lag, and the lags [samples]."""
    from scipy.signal import correlate, correlation_lags

    lags = correlation_lags(first.size, second.size)
    shared = correlate(np.ones(first.size), np.ones(second.size))
    kept = shared > 0.1 * min(first.size, second.size)
    powers = correlate(first**2, np.ones(second.size)), correlate(np.ones(first.size), second**2)
    least = 1e-9 * max(float((first**2).sum()), float((second**2).sum()))
    if float((first**2).sum()) == 0 or float((second**2).sum()) == 0:
        return None, lags
    below = np.sqrt(np.clip(powers[0], least, None) * np.clip(powers[1], least, None))
    return (correlate(first, second) / below)[kept], lags[kept].astype(np.int64)


def _between(values: NDArray[np.float64], at: int) -> float:
    """Return where between the samples the parabola through three of them is highest [samples]."""
    if not 0 < at < values.size - 1:
        return 0.0
    low, mid, high = values[at - 1 : at + 2]
    bend = low - 2 * mid + high
    return float(0.5 * (low - high) / bend) if bend < 0 else 0.0
