"""Orders of lines that an unmeasured angle smears until no peak stands out: humps that move with the speed.

A line of a high order under a load that shakes the shaft is some per cent wide, and its peak no higher than noise. A
mode of that width stays at its frequency when the speed is another; the line stays at its order.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed

Floats = NDArray[np.float64]

_ORDERS = (8.0, 400.0)  # of the motor: below, an angle from the set-point smears little
_STEP = 0.002  # of the order's logarithm
_HALF = 4  # steps either way that are gathered
_BESIDE = (15, 35)  # steps aside that the floor is taken from
_STANDS_OUT = 1.5  # logarithm of the power over the floor on either side; 40 bins scatter by 0.16
_NONE = -9.0
_OTHER_SPEED = 0.06  # logarithm: speeds nearer than this do not tell an order from a frequency
_NEAR = 0.02  # of an order: what stands nearer to a known one is not told from it
_WHOLE = 0.006  # of an order: what the speed may be off by
_TOP = 0.42  # of the sample rate


def smeared_orders(runs: Sequence[Observed], known: Sequence[float], *, ratio: float) -> tuple[float, ...]:
    """Return the orders of the motor [1/rev] at which steady runs of two speeds show a hump, and no frequency does.

    Parameters
    ----------
    runs : sequence of Observed
        Those whose angle was measured are left out: a measured angle smears nothing.
    known : sequence of float
        Orders that need not be told [1/rev of the motor].
    ratio : float
        Turns of the motor per turn of the output, at whose whole orders lines stand.
    """
    steady = [run for run in runs if run.steady and not run.angle_measured]
    heights = [_heights(run) for run in steady]
    orders = np.exp(_grid())
    found: dict[float, float] = {}
    for (one, first), (other, second) in combinations(zip(steady, heights, strict=True), 2):
        apart = float(np.log(abs(one.mean_speed / other.mean_speed)))
        if abs(apart) < _OTHER_SPEED:
            continue
        both, shift = np.minimum(_widest(first, 2), _widest(second, 2)), round(apart / _STEP)
        for at in _tops(both):
            stays = max(_near(second, at + shift), _near(first, at - shift))
            place = _meant(float(orders[at]), ratio)
            if stays < 0.5 * _STANDS_OUT and all(abs(place / order - 1) > _NEAR for order in known):
                found[place] = max(found.get(place, 0.0), float(both[at]))
    clearest = sorted(found, key=lambda place: -found[place])
    return tuple(p for i, p in enumerate(clearest) if all(abs(p / q - 1) > _NEAR for q in clearest[:i]))


def _grid() -> Floats:
    return np.arange(np.log(_ORDERS[0]), np.log(_ORDERS[1]), _STEP)


def _heights(run: Observed) -> Floats:
    """Return the logarithm of the power gathered around each order over that beside it, on the higher side."""
    torque = run.torque[run.seen]
    power = np.abs(np.fft.rfft((torque - torque.mean()) * np.hanning(torque.size))) ** 2
    summed = np.concatenate([[0.0], np.cumsum(power)])
    bins = np.exp(_grid()) * abs(run.mean_speed) / (2 * pi) * torque.size / run.rate
    low, high = (np.ceil(bins * np.exp(side * _HALF * _STEP)).astype(int) for side in (-1, 1))
    shown = (high > low + 2) & (bins < _TOP * torque.size)
    low, high = (np.where(shown, edge, 0) for edge in (low, high))
    density = np.log(np.maximum((summed[high] - summed[low]) / np.maximum(high - low, 1), 1e-300))
    near, far = _BESIDE
    answer = np.full(density.size, _NONE)
    for at in range(far, density.size - far):
        if shown[at - far : at + far].all():
            sides = density[at - far : at - near], density[at + near : at + far]
            answer[at] = density[at] - max(float(np.median(side)) for side in sides)
    return answer


def _widest(heights: Floats, reach: int) -> Floats:
    return np.asarray(np.max([np.roll(heights, by) for by in range(-reach, reach + 1)], axis=0))


def _tops(heights: Floats) -> list[int]:
    """Return the middle of each stretch that is higher than all within the width of a line."""
    above = [at for at in np.flatnonzero(heights > _STANDS_OUT) if heights[at] == _near(heights, int(at), 2 * _HALF)]
    groups = np.split(above, np.flatnonzero(np.diff(above) > _HALF) + 1) if above else []
    return [int(np.mean(group)) for group in groups]


def _near(heights: Floats, at: int, reach: int = _HALF) -> float:
    """Return the largest height near a step, that of nothing beyond the ends."""
    return float(heights[max(at - reach, 0) : at + reach + 1].max(initial=_NONE)) if 0 <= at < heights.size else _NONE


def _meant(at: float, ratio: float) -> float:
    """Return the whole order of the motor that is meant, else the nearest one of the output."""
    return float(round(at)) if abs(at / round(at) - 1) < _WHOLE else round(at * ratio) / ratio
