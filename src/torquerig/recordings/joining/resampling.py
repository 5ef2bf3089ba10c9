"""A track at the times of a common grid."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.joining.track import Track

_OVERSAMPLING = 8  # a cubic line through 8 times finer samples is within 1e-4 up to 0.4 of the rate
_PASSED = 0.9  # of half the lower rate: what the low-pass before a slower grid keeps
_PIECE = 2**16  # samples that are interpolated at once
_HALF_LENGTH = 32  # samples that the interpolating filter reaches to either side
_MARGIN = 64  # samples on either side of a piece, longer than the interpolating filter
_STEPPED = ("tacho", "motor_angle", "angle")


def resampled(track: Track, *, rate: float, start: float, samples: int) -> NDArray[np.float64]:
    """Return the track at the times ``start + n / rate`` [s], shape (samples,); beyond its ends the end values.

    A slower grid has a linear-phase low-pass before it, so that nothing is aliased. A tacho, and an angle that wraps,
    keep their last sample instead, because values between two samples would be no readings.
    """
    positions = (start - track.start + np.arange(samples) / rate) * track.rate
    if is_stepped(track):
        held = np.clip(np.floor(positions + 1e-6).astype(np.int64), 0, track.values.size - 1)
        return np.asarray(track.values[held])
    shift = positions[0] if samples else 0.0
    if abs(rate / track.rate - 1) < 1e-12 and abs(shift - round(shift)) < 1e-6:
        whole = np.clip(np.arange(samples) + round(shift), 0, track.values.size - 1)
        return np.asarray(track.values[whole])
    values = _low_passed(track.values, rate / track.rate) if rate < track.rate else track.values
    return _between(values, positions)


def is_stepped(track: Track) -> bool:
    """Whether the values between two samples of the track are no readings: a tacho, or an angle that wraps."""
    if track.entry.quantity == "tacho":
        return True
    if track.entry.quantity not in _STEPPED or track.values.size < 3:
        return False
    steps = np.diff(track.values)
    usual = float(np.median(np.abs(steps)))
    return bool(np.abs(steps).max() > 10 * usual + np.ptp(track.values) / 4)


def _low_passed(values: NDArray[np.float64], ratio: float) -> NDArray[np.float64]:
    """Return the signal below the new half rate; the ends are mirrored at their end values."""
    from scipy.signal import fftconvolve, firwin

    half = int(np.ceil(32 / ratio))
    taps = firwin(2 * half + 1, _PASSED * ratio, window=("kaiser", 8.0))
    padded = np.pad(values, half, mode="reflect", reflect_type="odd")
    low: NDArray[np.float64] = fftconvolve(padded, taps, mode="valid")
    return low


def _between(values: NDArray[np.float64], positions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return values between the samples, in pieces, so that the finer grid takes little memory."""
    inside = np.clip(positions, 0, values.size - 1)
    found = np.empty(inside.size)
    for first in range(0, inside.size, _PIECE):
        piece = inside[first : first + _PIECE]
        low = max(int(piece[0]) - _MARGIN, 0)
        high = min(int(piece[-1]) + _MARGIN + 2, values.size)
        found[first : first + _PIECE] = _finer(values[low:high], piece - low)
    return found


def _finer(values: NDArray[np.float64], positions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return values between the samples: band-limited to a finer grid, then by cubic lines."""
    from scipy.interpolate import CubicSpline
    from scipy.signal import firwin, resample_poly

    if values.size == 1:
        return np.full(positions.size, values[0])
    ends = [0, values.size - 1]
    trend = np.interp(np.arange(values.size), ends, values[ends])
    taps = firwin(2 * _HALF_LENGTH * _OVERSAMPLING + 1, 1 / _OVERSAMPLING, window=("kaiser", 8.0))
    fine = resample_poly(values - trend, _OVERSAMPLING, 1, window=taps)[: (values.size - 1) * _OVERSAMPLING + 1]
    spline = CubicSpline(np.arange(fine.size) / _OVERSAMPLING, fine)
    return np.asarray(spline(positions) + np.interp(positions, ends, values[ends]))
