"""The angle [rad] of an angle channel: counts unwrapped where the counter runs over, and smoothed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Channel

# smoothing spans this many encoder counts, but never more than this long, so that real speed ripple stays
_COUNTS_SPANNED, _LONGEST_SMOOTHING = 16, 2e-3


def angle_of(channel: Channel, rate: float) -> NDArray[np.float64]:
    """Return an angle channel in radians, shape (samples,); counts are unwrapped and smoothed first."""
    values = channel.values
    if values.size < 3:
        return channel.in_si()
    if channel.unit == "count":
        values = _smoothed(_unwrapped(values, counts_per_rev=2 * np.pi / channel.si_per_unit), rate)
        values *= channel.si_per_unit  # in place: smoothing returned a new array
        return values
    return channel.in_si()


def unsmoothed_angle_of(channel: Channel) -> NDArray[np.float64]:
    """Return an angle channel in radians, shape (samples,), as it was recorded; counts are unwrapped."""
    if channel.unit != "count" or channel.values.size < 3:
        return channel.in_si()
    turn = 2 * np.pi / channel.si_per_unit
    return np.asarray(_unwrapped(channel.values, counts_per_rev=turn) * channel.si_per_unit)


def _unwrapped(counts: NDArray[np.float64], *, counts_per_rev: float) -> NDArray[np.float64]:
    """Unwrap a counter that overflows at one turn, or at 16 or 32 bit."""
    steps = np.diff(counts)
    largest = max(steps.max(), -steps.min())
    span = counts.max() - counts.min()
    moduli = [round(counts_per_rev), 2**16, 2**32]
    modulus = next((m for m in moduli if largest > 0.5 * m and span <= m), None)
    if modulus is None:
        return counts
    return np.concatenate([counts[:1], counts[0] + np.cumsum(steps - modulus * np.round(steps / modulus))])


def _smoothed(counts: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
    per_sample = np.abs(counts[-1] - counts[0]) / (counts.size - 1)
    window = int(min(np.ceil(_COUNTS_SPANNED / max(per_sample, 1e-9)), _LONGEST_SMOOTHING * rate))
    deviation = _trend(counts)
    np.subtract(counts, deviation, out=deviation)
    # long recordings: as few arrays in memory at a time as possible
    smooth = _even_mean(deviation, max(window // 2, 2))
    del deviation
    smooth += _trend(counts)
    return smooth


def _trend(counts: NDArray[np.float64]) -> NDArray[np.float64]:
    trend = np.linspace(0.0, 1.0, counts.size)
    trend *= counts[-1] - counts[0]
    trend += counts[0]
    return trend


def _even_mean(values: NDArray[np.float64], reach: int) -> NDArray[np.float64]:
    """Return the mean over ``reach`` samples either way; near the ends over fewer, but equally many on both sides."""
    size = values.size
    sums = np.zeros(size + 1)
    np.cumsum(values, out=sums[1:])
    reach = min(reach, (size - 1) // 2)
    means = np.empty(size)
    inner = means[reach : size - reach]
    np.subtract(sums[2 * reach + 1 :], sums[: size - 2 * reach], out=inner)
    inner /= 2 * reach + 1
    fewer = np.arange(reach)
    means[:reach] = sums[2 * fewer + 1] / (2 * fewer + 1)
    means[size - reach :] = ((sums[-1] - sums[size - 1 - 2 * fewer]) / (2 * fewer + 1))[::-1]
    return means
