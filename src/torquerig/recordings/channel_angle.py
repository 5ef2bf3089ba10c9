"""The angle [rad] of an angle channel: unwrapped where it starts again after a turn or an overflow; counts smoothed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Channel

# smoothing spans this many encoder counts, but never more than this long, so that real speed ripple stays
_COUNTS_SPANNED, _LONGEST_SMOOTHING = 16, 2e-3


# a counter overflows at a power of two, or after so many of the turns that the sidecar states
_BITS = range(8, 33)
_OF_A_TURN = (2.0, 4.0, 0.5, 0.25)
_FILLED = 0.9  # share of such a range that the values cover, at least
_ROUNDED = 1.01  # values between 0 and 360.0 may be rounded or noisy


def angle_of(channel: Channel, rate: float) -> NDArray[np.float64]:
    """Return an angle channel in radians, shape (samples,); unwrapped, and counts smoothed."""
    if channel.values.size < 3:
        return channel.in_si()
    if channel.unit == "count":
        values = _smoothed(_unwrapped(channel), rate)
        values *= channel.si_per_unit  # in place: smoothing returned a new array
        return values
    return unsmoothed_angle_of(channel)


def unsmoothed_angle_of(channel: Channel) -> NDArray[np.float64]:
    """Return an angle channel in radians, shape (samples,), as it was recorded but unwrapped."""
    if channel.values.size < 3:
        return channel.in_si()
    unwrapped = _unwrapped(channel)
    return unwrapped if channel.si_per_unit == 1.0 else np.asarray(unwrapped * channel.si_per_unit)


def wrap_of(channel: Channel) -> float | None:
    """Return the range [unit of the channel] after which an angle channel starts again, or None where it does not.

    It starts again where it steps by more than half of a range that holds all its values: one turn; 16 or 32 bit; or
    another power of two, or a simple multiple of a turn, that the values fill.
    """
    values = channel.values
    if values.size < 3:
        return None
    span, steps = float(np.ptp(values)), np.diff(values)
    largest = float(max(steps.max(), -steps.min()))
    turn = 2 * np.pi / channel.si_per_unit
    if channel.unit == "count":
        likely = [float(round(turn)), 2.0**16, 2.0**32]
        others = [2.0**bits for bits in _BITS] + [round(turn * share) for share in _OF_A_TURN]
    else:
        likely, others = [turn], []
    filled = [each for each in sorted(others) if span > _FILLED * each]
    fits = (each for each in (*likely, *filled) if largest > 0.5 * each and span <= _ROUNDED * each)
    return next(fits, None)


def _unwrapped(channel: Channel) -> NDArray[np.float64]:
    values, wrap = channel.values, wrap_of(channel)
    if wrap is None:
        return values
    steps = np.diff(values)
    return np.concatenate([values[:1], values[0] + np.cumsum(steps - wrap * np.round(steps / wrap))])


def smoothing_reach(channel: Channel, rate: float) -> int:
    """Return over how many samples on either side :func:`angle_of` takes the mean of a channel in counts."""
    return _reach(_unwrapped(channel), rate)


def _reach(counts: NDArray[np.float64], rate: float) -> int:
    per_sample = np.abs(counts[-1] - counts[0]) / (counts.size - 1)
    window = int(min(np.ceil(_COUNTS_SPANNED / max(per_sample, 1e-9)), _LONGEST_SMOOTHING * rate))
    return max(window // 2, 2)


def _smoothed(counts: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
    reach = _reach(counts, rate)
    deviation = _trend(counts)
    np.subtract(counts, deviation, out=deviation)
    # long recordings: as few arrays in memory at a time as possible
    smooth = _even_mean(deviation, reach)
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
