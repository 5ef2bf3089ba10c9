"""How late one signal follows another: the peak of their cross-correlation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError

if TYPE_CHECKING:
    from numpy.typing import NDArray

LONGEST = 0.25  # [s] lags beyond this are not looked at: a wear rig's load repeats with the turn, 0.3 s


@dataclass(frozen=True)
class Delay:
    """By how much a signal comes later [s], negative where it comes earlier, and how like the other it then is [1]."""

    seconds: float
    correlation: float


def delay_behind(
    values: NDArray[np.float64], first: NDArray[np.float64], *, rate: float, longest: float = LONGEST
) -> Delay | None:
    """Return by how much ``values`` comes later than ``first``; None where one of them does not change.

    The lag of the highest cross-correlation of the deviations from the mean, a parabola through it and its
    neighbours.

    Parameters
    ----------
    values, first : ndarray, shape (samples,)
        Of the same run.
    rate : float
        [Hz].
    longest : float
        Lags up to this either way are looked at [s].

    Raises
    ------
    RecordingError
        For signals of different length, or fewer than eight samples.

    Notes
    -----
    Source: Knapp & Carter 1976, IEEE Trans. ASSP 24(4), plain correlation. It is one delay for all frequencies: that
    of the slow part where a signal is mostly slow. Where frequencies are delayed differently, the correlation says so.
    """
    if values.size != first.size or values.size < 8:
        raise RecordingError(
            f"{values.size} and {first.size} samples have no common delay; give two signals of one run"
        )
    late, early = (one - one.mean() for one in (values, first))
    scale = float(np.sqrt((late @ late) * (early @ early)))
    if scale <= 1e-12 * values.size * max(float(np.abs(values).max()), float(np.abs(first).max()), 1e-300) ** 2:
        return None
    from scipy.fft import next_fast_len

    reach = min(max(round(longest * rate), 2), values.size - 2)
    size = next_fast_len(values.size + reach + 1, real=True)
    spectrum = np.fft.rfft(late, size) * np.conj(np.fft.rfft(early, size))
    around = np.fft.irfft(spectrum, size)
    lags = np.concatenate([around[-reach:], around[: reach + 1]]) / scale
    best = int(np.argmax(lags))
    shift, height = _parabola(lags, best)
    return Delay((best + shift - reach) / rate, height)


def _parabola(values: NDArray[np.float64], best: int) -> tuple[float, float]:
    """Where the peak of a parabola through three points lies from ``best``, and how high it is."""
    if not 0 < best < values.size - 1:
        return 0.0, float(values[best])
    left, middle, right = (float(one) for one in values[best - 1 : best + 2])
    bend = left - 2 * middle + right
    shift = 0.5 * (left - right) / bend if bend else 0.0
    return shift, middle - 0.25 * (left - right) * shift
