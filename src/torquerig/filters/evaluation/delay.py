"""Delay of one signal behind another, from the peak of their cross-correlation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.evaluation.load_scale import WEAR_PART

if TYPE_CHECKING:
    from numpy.typing import NDArray

DECAYS = 62.5  # decay times of a hit up to which a lag is searched: 0.25 s at 4 ms; the reference rig turns in 0.3 s


@dataclass(frozen=True)
class Delay:
    """The delay [s], negative where the signal is early, and the correlation at this lag [1]."""

    seconds: float
    correlation: float


def delay_behind(
    values: NDArray[np.float64],
    first: NDArray[np.float64],
    *,
    rate: float,
    longest: float = DECAYS * WEAR_PART.hit_decay,
) -> Delay | None:
    """Return the delay of ``values`` behind ``first``; None where one of them is constant.

    The lag of the highest cross-correlation of the deviations from the mean, refined by a parabola.

    Parameters
    ----------
    values, first : ndarray, shape (samples,)
        Of the same run.
    rate : float
        [Hz].
    longest : float
        Largest lag in either direction [s].

    Raises
    ------
    RecordingError
        For signals of different length, or fewer than eight samples.

    Notes
    -----
    Source: Knapp & Carter 1976, IEEE Trans. ASSP 24(4), plain correlation. It is one delay for all frequencies,
    dominated by the slow part of the signal. Where the delay depends on frequency, the correlation is low.
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
    """Return the offset of the peak of a parabola through three points from ``best``, and its height."""
    if not 0 < best < values.size - 1:
        return 0.0, float(values[best])
    left, middle, right = (float(one) for one in values[best - 1 : best + 2])
    bend = left - 2 * middle + right
    shift = 0.5 * (left - right) / bend if bend else 0.0
    return shift, middle - 0.25 * (left - right) * shift
