"""Score of a comb of order lines along an angle: a correct angle gives a higher score than a wrong one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.line_sums.sums import order_sums

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_OF_NOISE = 0.6  # mean of log(1 + x) of an exponential x of mean 1 (exactly 0.596)
_FEWEST = 20  # bins on either side of a line from which its noise floor is taken, at least


def comb_score(torque: Floats, angle: Floats, orders: Floats, floor: Floats) -> float:
    """Return the sum of the logs of the lines' power over the noise floor, less the value expected of noise alone.

    Parameters
    ----------
    torque, angle : ndarray, shape (samples,)
        Angle in [rad].
    orders : ndarray, shape (lines,)
        [1/rev].
    floor : ndarray, shape (lines,)
        Noise power of a bin near each line [unit of the torque squared]; infinite where it is not known.
    """
    known = np.isfinite(floor)
    edges = np.array([0, torque.size])
    in_phase, quadrature = order_sums(torque, angle / (2 * np.pi), orders[known], edges, offset=torque.mean())[:, :, 0]
    heights = np.log1p((in_phase**2 + quadrature**2) / torque.size / floor[known])
    return float(np.sum(heights - _OF_NOISE))


def order_power(torque: Floats, angle: Floats) -> tuple[Floats, float]:
    """Return the power of each bin of the order spectrum, and the bin width [1/rev]; white noise is equal in all bins.

    ``angle`` [rad] rises.
    """
    turned = np.abs(angle)
    even = np.linspace(turned[0], turned[-1], torque.size)
    signal = np.interp(even, turned, torque) if np.ptp(np.diff(turned)) > 1e-9 * turned[-1] else torque
    window = np.hanning(signal.size)
    power = np.abs(np.fft.rfft((signal - signal.mean()) * window)) ** 2 / (window**2).sum()
    return power, float(2 * np.pi / ((turned[-1] - turned[0]) * signal.size / (signal.size - 1)))


def noise_floor_at(power: Floats, positions: Floats, *, within: float) -> Floats:
    """Return the noise power of a bin near each position [bins], from the bins within the share ``within`` of it."""
    return np.array([_floor(power, float(position), within) for position in positions])


def _floor(power: Floats, position: float, within: float) -> float:
    half = max(int(position * within), _FEWEST)
    near = power[max(int(position) - half, 1) : int(position) + half]
    # the median of a chi-square with two degrees of freedom is ln 2 of its mean
    return float(np.median(near) / np.log(2)) + 1e-300 if near.size else float(np.inf)
