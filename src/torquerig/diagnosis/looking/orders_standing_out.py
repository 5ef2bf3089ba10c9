"""Whether lines stand out of the torque at some orders of the motor: what a sheet says of the gears is held to it."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed

Floats = NDArray[np.float64]

SLOWEST = 3.0  # bins that an order must be above standstill
_RATE = 1000.0  # [Hz] to which the torque is averaged down; lines above a fifth of it are not looked at
_BESIDE = np.arange(3, 13)  # bins on either side of a line that tell what chance makes there
_WIDE = 2.5  # bins to either side that a line fills under a Hann window, where it is not to be taken for chance


def turns_of(run: Observed) -> float:
    """Return the turns of the motor over the run, of which one more makes a bin."""
    return float(abs(run.angle[-1] - run.angle[0]) / (2 * pi))


def taken_together(chances: Sequence[float]) -> float:
    """Return the probability that chance makes all of them so small, 1 where there are none.

    By the sum of their logarithms (Fisher 1932, Statistical Methods for Research Workers, 21.1).
    """
    from scipy.stats import chi2

    logarithms = -np.log(np.maximum(chances, 1e-300))
    return float(chi2.sf(2 * logarithms.sum(), 2 * logarithms.size)) if logarithms.size else 1.0


def chances_of_orders(run: Observed, orders: Sequence[float], *, others: Sequence[float] = ()) -> list[float]:
    """Return with what probability chance alone makes what stands at each of these orders that can be looked at.

    Each line's power over the mean of those beside it, all under a Hann window along the motor's angle; under chance
    that ratio is one of chi-squares, of two degrees of freedom and of twice as many as there are bins beside.

    Parameters
    ----------
    run : Observed
        A steady run.
    orders : sequence of float
        Of the motor.
    others : sequence of float
        Orders at which other lines may stand: nothing of these is taken for chance.
    """
    each = max(1, int(run.rate / _RATE))
    size = run.torque.size // each * each
    torque = run.torque[:size].reshape(-1, each).mean(axis=1)
    angle = run.angle[:size].reshape(-1, each).mean(axis=1)
    turns = turns_of(run)
    fastest = 0.2 * run.rate / each / (abs(run.mean_speed) / (2 * pi))
    window = np.hanning(torque.size)
    centred = (torque - np.average(torque, weights=window)) * window
    taken = np.array([*orders, *others]) * turns

    def power(bins: float) -> float:
        return float(np.abs(centred @ np.exp(-1j * bins / turns * angle)) ** 2)

    chances: list[float] = []
    for order in orders:
        at = order * turns
        beside = [at + way * step for way in (-1, 1) for step in _BESIDE]
        clear = [one for one in beside if one > SLOWEST and np.abs(taken - one).min() > _WIDE]
        if at < SLOWEST or order > fastest or len(clear) < _BESIDE.size // 2:
            continue
        ratio = power(at) / np.mean([power(one) for one in clear])
        chances.append(float((1 + ratio / len(clear)) ** -len(clear)))
    return chances
