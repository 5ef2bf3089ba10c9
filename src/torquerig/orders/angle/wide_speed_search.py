"""The speed of a steady run whose stated speed is far off: search for the comb of its orders over a wide range."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_LOW, _HIGH = 0.5, 2.0  # range of the search, times the set-point
_HIGHEST = 30.0  # [1/rev] highest motor order: faster lines are smeared and coincide with noise peaks more often
_FLOOR = 60  # bins on either side from which the local noise floor is taken
_CLEAR = 8.0  # robust standard deviations of the best score over the median of all speeds, at least
_AHEAD = 1.3  # ratio of the best score to that of any other speed, at least
_NEAR = 0.01  # [1] speeds within this relative distance count as the same
_CAPPED = 6.0  # largest contribution of one order to the score, so that one strong line is not a comb


def wide_speed_search(torque: Floats, rate: float, *, set_point: float, orders: Sequence[float]) -> float | None:
    """Return the motor's speed [rad/s] with a clearly highest score of the comb of orders, or None.

    Parameters
    ----------
    torque : ndarray, shape (samples,)
        Of a steady run, in any unit.
    rate : float
        Samples per second [Hz].
    set_point : float
        Stated motor speed [rad/s], of either sign; speeds from half of it to twice are tried.
    orders : sequence of float
        Known orders of the motor.

    Notes
    -----
    The score of a speed is the sum over the orders of the logarithm of power over the local floor, each at most 6,
    less the median over all speeds. A speed at which only some orders fit, such as half the true one, has a
    proportionally lower score.
    """
    power = np.abs(np.fft.rfft((torque - torque.mean()) * np.hanning(torque.size))) ** 2
    over = np.minimum(np.log1p(power / _floor(power)), _CAPPED)
    wanted = np.array(sorted({order for order in orders if order <= _HIGHEST}))
    if not wanted.size:
        return None
    step = rate / torque.size
    turns = abs(set_point) / (2 * np.pi)
    fine = 0.25 * step / (wanted.max() * turns)
    factors = np.arange(_LOW, _HIGH, fine)
    score = np.zeros(factors.size)
    for order in wanted:
        at = np.round(order * turns * factors / step).astype(np.int64)
        score += np.where(at < over.size, over[np.minimum(at, over.size - 1)], 0.0)
    score -= float(np.median(score))
    best = int(np.argmax(score))
    deviation = 1.4826 * float(np.median(np.abs(score)))
    elsewhere = score[np.abs(factors / factors[best] - 1) > _NEAR]
    clear = score[best] > _CLEAR * deviation and score[best] > _AHEAD * float(elsewhere.max())
    return float(factors[best] * set_point) if clear else None


def _floor(power: Floats) -> Floats:
    from scipy.ndimage import median_filter

    return np.asarray(np.maximum(median_filter(power, size=2 * _FLOOR + 1, mode="nearest") / np.log(2), 1e-300))
