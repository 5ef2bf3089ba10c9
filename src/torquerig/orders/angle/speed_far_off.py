"""Whether a steady run turns at quite another speed than its sheet says: the comb of its orders, far and wide."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_LOW, _HIGH = 0.5, 2.0  # times the set-point
_HIGHEST = 30.0  # [1/rev] of the motor: what turns faster is smeared, and chance falls on it sooner
_FLOOR = 60  # bins either way that make the local floor
_STANDS_OUT = 8.0  # robust standard deviations over the median of all speeds
_AHEAD = 1.3  # times the score of any speed that is no near neighbour
_NEAR = 0.01  # speeds nearer than this are one
_CAPPED = 6.0  # of the logarithm: one strong line shall not make a comb


def speed_far_off(torque: Floats, rate: float, *, set_point: float, orders: Sequence[float]) -> float | None:
    """Return the motor's speed [rad/s] for which the comb of orders stands out, or None where none clearly does.

    Parameters
    ----------
    torque : ndarray, shape (samples,)
        Of a steady run, in any unit.
    rate : float
        Samples per second [Hz].
    set_point : float
        Motor speed of the sheet [rad/s]; speeds from half of it to twice are tried.
    orders : sequence of float
        Known orders of the motor.

    Notes
    -----
    The score of a speed is the sum over the orders of the logarithm of power over the local floor, each at most 6, less
    what noise has. A speed at which only a part of the orders fits (half the true one, say) scores in proportion.
    """
    power = np.abs(np.fft.rfft((torque - torque.mean()) * np.hanning(torque.size))) ** 2
    over = np.minimum(np.log1p(power / _floor(power)), _CAPPED)
    wanted = np.array(sorted({order for order in orders if order <= _HIGHEST}))
    if not wanted.size:
        return None
    step = rate / torque.size
    turns = set_point / (2 * np.pi)
    fine = 0.25 * step / (wanted.max() * turns)
    factors = np.arange(_LOW, _HIGH, fine)
    score = np.zeros(factors.size)
    for order in wanted:
        at = np.round(order * turns * factors / step).astype(np.int64)
        score += np.where(at < over.size, over[np.minimum(at, over.size - 1)], 0.0)
    score -= float(np.median(score))
    best = int(np.argmax(score))
    spread = 1.4826 * float(np.median(np.abs(score)))
    elsewhere = score[np.abs(factors / factors[best] - 1) > _NEAR]
    clear = score[best] > _STANDS_OUT * spread and score[best] > _AHEAD * float(elsewhere.max())
    return float(factors[best] * set_point) if clear else None


def _floor(power: Floats) -> Floats:
    from scipy.ndimage import median_filter

    return np.asarray(np.maximum(median_filter(power, size=2 * _FLOOR + 1, mode="nearest") / np.log(2), 1e-300))
