"""How likely lines are along an angle: their power over the noise, seen with a window that leaks little."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.line_sums.sums import order_sums

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_OF_NOISE = 0.6  # mean of log(1 + x) of an exponential x of mean 1 (exactly 0.596)


def line_power(torque: Floats, angle: Floats, orders: Floats, floor: Floats) -> Floats:
    """Return the power of each line over that of the noise at its place [1], shape (orders,).

    Parameters
    ----------
    torque, angle : ndarray, shape (samples,)
        The torque in any unit, and the angle [rad].
    orders, floor : ndarray, shape (orders,)
        Orders [1/rev], and the noise power of a bin near each [unit of the torque squared].

    Notes
    -----
    With a Hann window. It is the logarithm of the likelihood ratio of the line to noise alone.
    """
    window = np.hanning(torque.size)
    edges = np.array([0, torque.size])
    windowed = (torque - torque.mean()) * window
    in_phase, quadrature = order_sums(windowed, angle / (2 * np.pi), orders, edges)[:, :, 0]
    return np.asarray((in_phase**2 + quadrature**2) / float((window**2).sum()) / floor)


def line_scores(torque: Floats, angle: Floats, orders: Floats, floor: Floats) -> Floats:
    """Return the log of one plus each :func:`line_power`, less the value expected of noise; 0 where no floor is known.

    The logarithm limits the weight of the strongest line, which may be hum.
    """
    known = np.isfinite(floor)
    scores = np.zeros(orders.size)
    scores[known] = np.log1p(line_power(torque, angle, orders[known], floor[known])) - _OF_NOISE
    return scores
