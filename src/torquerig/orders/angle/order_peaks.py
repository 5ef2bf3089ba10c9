"""The peaks of the torque's spectrum near known orders: position, its uncertainty, and power over the noise floor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_PADDED = 2  # points of the spectrum per bin, at least
_EXACT = 1e-5  # [bins] error of a position without noise: unequal steps of the angle, rounding
_SHIFTED = 1.2  # [bins] shift of a maximum per share of leakage: pi / (curvature of the window's line, 1.29) / 2
_LOWEST = 7.0  # [1] power over the floor of a peak, at least: noise has one in 1100 bins
_NOISE_PEAKS = 50.0  # peaks of noise that may remain in a long spectrum: the least power rises with its length
_BESIDE = 30  # bins on either side of a peak from which its noise floor is taken
_SHARE = 0.005  # [1] and this share of its frequency, where that is more
_FEWEST = 10  # bins on either side, at least
_ROUGH = 64  # points of a block of the first, rough floor, which saves most of the time
_EDGE = 4.0  # ratio of the noise on both sides beyond which a band ends here, and the larger counts
_SKIRT = 0.5  # [1] a peak below this multiple of the leakage of stronger peaks (amplitudes) is leakage


@dataclass(frozen=True)
class OrderPeaks:
    """Peaks of a spectrum over orders.

    Parameters
    ----------
    at : ndarray, shape (peaks,)
        Position [1/rev of the given angle].
    sd : ndarray, shape (peaks,)
        Standard uncertainty of the position by noise and by the leakage of other peaks [1/rev].
    over_floor : ndarray, shape (peaks,)
        Power over the mean power of the noise near the peak [1].
    power : ndarray, shape (peaks,)
        Power of the peak, scaled so that white noise has its variance [unit of the torque squared].
    width : float
        Width of a bin of the spectrum [1/rev].
    """

    at: Floats
    sd: Floats
    over_floor: Floats
    power: Floats
    width: float


def order_peaks(torque: Floats, angle: Floats, orders: Floats, *, reach: float) -> OrderPeaks:
    """Return the peaks within the share ``reach`` of each order.

    Parameters
    ----------
    torque, angle : ndarray, shape (samples,)
        The torque in any unit, and an angle that rises [rad].
    orders : ndarray, shape (orders,)
        [1/rev].
    reach : float
        [1].

    Notes
    -----
    The uncertainty is that of the maximum of a periodogram with a Hann window in white noise: its variance is 2.34
    times the Cramer-Rao bound (Rife & Boorstyn 1974, IEEE Trans. Inf. Theory 20, eq. 17). The floor is the geometric
    mean of the medians on both sides; at the edge of a band of noise the larger, so that the edge is no row of peaks.
    """
    power, width, per_bin = _padded_order_power(torque, angle)
    near = _near(orders, reach, width, power.size)
    top = near[(power[near] > power[near - 1]) & (power[near] >= power[near + 1])]
    needed = max(_LOWEST, float(np.log(max(near.size / _PADDED / _NOISE_PEAKS, 1.0))))
    top = top[power[top] > 1.2 * needed * _rough_floor(power)[top // _ROUGH]]
    floor = np.array([_floor(power, int(at)) for at in top])
    floor = np.array([_floor(power, int(at), beyond=power[at] / level) for at, level in zip(top, floor, strict=True)])
    kept = power[top] > needed * floor
    top, floor = top[kept], floor[kept]
    before, middle, after = (np.log(power[top + step]) for step in (-1, 0, 1))
    vertex = 0.5 * (before - after) / (before - 2 * middle + after)
    height = np.exp(middle - 0.25 * (before - after) * vertex) / floor
    shift = _unbiased(vertex, 1 / per_bin)
    at = (top + shift) / per_bin  # [bins]
    clear = _resolved(at, height * floor)
    at, height, floor = at[clear], height[clear], floor[clear]
    leakage = np.sqrt((_leakage(at, height * floor) ** 2).sum(axis=1))
    # the variance of the maximum, with a term for weak peaks that was found by simulation
    noise = 9.37 / (2 * np.pi) ** 2 / height * (1 + 2.5 / height)
    sd = np.sqrt(noise + _EXACT**2 + (_SHIFTED * leakage) ** 2)
    bins = per_bin * width
    return OrderPeaks(at * bins, sd * bins, height, height * floor, bins)


def _padded_order_power(torque: Floats, angle: Floats) -> tuple[Floats, float, float]:
    """Return the power at the points of the order spectrum, their distance [1/rev], and points per bin."""
    from scipy.fft import next_fast_len, rfft

    turned = np.abs(angle)
    even = np.linspace(turned[0], turned[-1], torque.size)
    is_even = np.ptp(np.diff(turned)) <= 1e-9 * turned[-1]
    signal = torque if is_even else np.interp(even, turned, torque)
    window = np.hanning(signal.size)
    size = next_fast_len(_PADDED * signal.size, real=True)
    lines = rfft((signal - signal.mean()) * window, n=size)
    power = (lines.real**2 + lines.imag**2) / (window**2).sum() + 1e-300
    step = (turned[-1] - turned[0]) / (2 * np.pi) / (signal.size - 1)
    return np.asarray(power), float(1 / (size * step)), size / signal.size


def _near(orders: Floats, reach: float, width: float, size: int) -> NDArray[np.int64]:
    """Return the points within ``reach`` of an order, and one more on either side, ascending."""
    wanted = np.zeros(size, dtype=bool)
    for order in orders:
        first, last = int(order * (1 - reach) / width) - 1, int(order * (1 + reach) / width) + 2
        wanted[max(first, 3 * _PADDED) : max(min(last + 1, size - 3), 0)] = True
    return np.flatnonzero(wanted)


def _rough_floor(power: Floats) -> Floats:
    """Return half the mean noise power, or less, of each block of points, by its median and those of its neighbours."""
    blocks = -(-power.size // _ROUGH)
    padded = np.pad(power, (0, blocks * _ROUGH - power.size), mode="edge").reshape(blocks, _ROUGH)
    medians = np.pad(np.median(padded, axis=1), 1, mode="edge")
    return np.asarray(0.7 * np.minimum(np.minimum(medians[:-2], medians[2:]), medians[1:-1]))


def _floor(power: Floats, at: int, *, beyond: float = 1.0) -> float:
    """Return the mean power of the noise near a point, from the medians on its two sides.

    Points where a peak of ``beyond`` times the noise leaks more than a tenth of the noise are left out.
    """
    gap = max(2, int((np.sqrt(10 * beyond) / np.pi) ** (1 / 3))) * _PADDED
    reach = int(max(min(max(_BESIDE * _PADDED, _SHARE * at) + gap, at / 2), _FEWEST * _PADDED))
    gap = min(gap, reach // 2)
    sides = power[max(at - reach, _PADDED) : max(at - gap, 0)], power[at + gap + 1 : at + reach + 1]
    levels = sorted(float(np.median(side)) for side in sides if side.size)
    if not levels:
        return float(np.inf)
    low, high = levels[0], levels[-1]
    # the median of a chi-square with two degrees of freedom is ln 2 of its mean
    return (high if high > _EDGE * low else float(np.sqrt(low * high))) / float(np.log(2)) + 1e-300


def _unbiased(vertex: Floats, step: float) -> Floats:
    """Return the true positions of maxima [points] from the vertex of the parabola through the logs of three points.

    ``step`` is the distance of the points [bins]. The line of a Hann window is no exact parabola.
    """
    true = np.linspace(-0.6, 0.6, 241)
    before, middle, after = (np.log(_hann_line((true - point) * step) ** 2) for point in (-1, 0, 1))
    return np.asarray(np.interp(vertex, 0.5 * (before - after) / (before - 2 * middle + after), true))


def _hann_line(away: Floats) -> Floats:
    """Return the amplitude of a line, seen with a Hann window, at a distance of less than 2 bins."""
    beyond = 1 - away**2
    near = np.abs(beyond) < 1e-9  # both factors vanish at one bin; the limit is a half
    return np.asarray(np.where(near, 0.5, np.abs(np.sinc(away)) / np.where(near, 1.0, np.abs(beyond))))


def _resolved(at: Floats, power: Floats) -> NDArray[np.bool_]:
    """Return whether each peak exceeds the leakage of the stronger ones, shape (peaks,)."""
    clear = np.zeros(at.size, dtype=bool)
    for peak in np.argsort(-power):
        stronger = np.flatnonzero(clear)
        leaked = _skirt(np.abs(at[peak] - at[stronger])) * np.sqrt(power[stronger] / power[peak])
        clear[peak] = float((leaked**2).sum()) < _SKIRT**2
    return clear


def _leakage(at: Floats, power: Floats) -> Floats:
    """Return the leakage of each peak into each other as a share of the other's amplitude, shape (peaks, peaks)."""
    skirt = _skirt(np.abs(at[:, None] - at))
    np.fill_diagonal(skirt, 0.0)
    return np.asarray(skirt * np.sqrt(power / power[:, None]))


def _skirt(away: Floats) -> Floats:
    """Return the amplitude of a line, seen with a Hann window, at a distance [bins]; beyond 2 bins its envelope."""
    far = np.maximum(away, 2.0)
    return np.asarray(np.where(away < 2, _hann_line(np.minimum(away, 2.0)), 1 / (np.pi * far * (far**2 - 1))))
