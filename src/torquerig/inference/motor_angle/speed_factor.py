"""By what factor a moving run without an encoder turns faster than its neighbours' speeds say: its lines tell."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_OFF = 0.013  # [1] a set-point is off by no more
_REACH, _STEPS = 0.024, 161  # [1] both ways, and factors tried
_PIECE = 0.8  # [s] over which a line keeps its phase; a stretch of a ramp is about as long
_STEP = 0.005  # [s] of the signal mixed down: the largest order tried strays by a few hertz
_FIRST = 1.0  # motor order: slower lines stand among the load's own variation
_CLEARLY = 15.0  # nats by which the lines must stand out further: where the angle is right, others gain 0.4 at most
_OTHER = 5e-4  # [1] nearer factors are the same: the lines keep their phase over a stretch


def speed_factor(torque: Floats, rate: float, angle: Floats, orders: Sequence[float], *, expected: float) -> float:
    """Return the factor of the angle along which the lines of ``orders`` stand out, 1 where they do along ``angle``.

    Each line is summed in phase over pieces of the run; what it holds there over its median for all factors is what it
    stands out by. A set-point that is off by another share in each run leaves a ramp's lines smeared along the angle
    that the steady runs tell.

    Parameters
    ----------
    torque : ndarray, shape (samples,)
    rate : float
        [Hz]
    angle : ndarray, shape (samples,)
        Expected, of the motor [rad].
    orders : sequence of float
        Of the motor; of lines that the rig is known to have.
    expected : float
        The real speed over the set-point along ``angle``.
    """
    tried = np.linspace(-_REACH, _REACH, _STEPS)
    step, length = max(1, round(_STEP * rate)), round(_PIECE / _STEP)
    pieces = torque.size // (step * length)
    if pieces == 0 or not np.ptp(torque):
        return 1.0
    used = slice(pieces * length * step)
    middles = angle[used][step // 2 :: step].reshape(pieces, length)
    away = middles - middles.mean(axis=1, keepdims=True)
    window = np.hanning(length + 2)[1:-1]
    told = np.zeros(_STEPS)
    for order in [order for order in orders if abs(order) >= _FIRST]:
        mixed = (torque[used] * np.exp(-1j * order * angle[used])).reshape(-1, step).mean(axis=1)
        windowed = mixed.reshape(pieces, length) * window
        held = np.array([np.abs((windowed * np.exp(-1j * order * off * away)).sum(axis=1)) ** 2 for off in tried])
        told += np.log1p(held / np.median(held, axis=0)).sum(axis=1)
    same, possible = np.abs(tried) <= _OTHER, np.abs(expected * (1.0 + tried) - 1.0) <= _OFF
    best = int(np.argmax(np.where(same | possible, told, 0.0)))
    return 1.0 + float(tried[best]) if told[best] - told[same].max() > _CLEARLY else 1.0
