"""Samples that a torque cannot have: spikes of a sample or two, and stretches that drop to a level and come back."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.inspection.runs import Run

MARGIN = 4096
"""Samples that a block needs on either side [1]; a dropout is no longer than that."""

# a second difference or a step this many times its usual size is worth a look
_STANDS_OUT, _STEP = 12.0, 8.0
# and this many times that of the dozen samples on either side
_ALONE = 5.0
# within a dropout the signal moves by less than this share of what it usually does
_QUIET = 0.25


def spikes_in(values: NDArray[np.float64]) -> list[int]:
    """Return the samples that stand out alone: one or two of them, with the signal going on behind as before.

    A spike is 12 times as far from the middle between its neighbours as is usual (by the median, which bursts do not
    move), and nearly all of its height is gone two samples on. A ringing that lasts several samples is none.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Without NaN.
    """
    if values.size < 16:
        return []
    bend = np.abs(values[1:-1] - 0.5 * (values[:-2] + values[2:]))
    usual = _usual(bend)
    least = _STANDS_OUT * usual if usual > 0 else 4 * _smallest_step(values)
    places = np.flatnonzero(bend > least) + 1
    places = places[(places >= 3) & (places < values.size - 3)]
    found: list[int] = []
    for place in places.tolist():
        around = values[[place - 3, place - 2, place + 2, place + 3]]
        height = abs(values[place] - float(np.median(around)))
        # a fast oscillation bends like that all the time
        alone = bend[place - 1] > _ALONE * float(np.median(bend[max(place - 12, 0) : place + 11]))
        if alone and height > max(least, 4 * float(np.ptp(around))) and not (found and place - found[-1] < 3):
            local = np.abs(values[place - 1 : place + 3] - np.median(around))
            found.append(place - 1 + int(np.argmax(local)))
    return found


def dropouts_in(values: NDArray[np.float64], *, longest: int) -> list[Run]:
    """Return the stretches that jump to a level, rest there and jump back: a lost contact, a cable, a missed block.

    Both jumps are 8 times the usual step, in opposite directions, at most ``longest`` samples apart; between them the
    signal moves by less than a quarter of what is usual.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Without NaN.
    longest : int
        Samples.
    """
    if values.size < 16:
        return []
    steps = np.diff(values)
    # where most samples do not move, held values are renewed: their steps are the usual ones
    usual = _usual(np.abs(steps)) or _usual(np.abs(steps[steps != 0]))
    jumps = np.flatnonzero(np.abs(steps) > _STEP * usual)
    found: list[Run] = []
    for place, after in zip(jumps[:-1].tolist(), jumps[1:].tolist(), strict=True):
        length = after - place
        back = steps[place] * steps[after] < 0
        if back and 3 <= length <= longest and (not found or place >= found[-1].last):
            inside = values[place + 1 : after + 1]
            if float(np.abs(np.diff(inside)).mean()) < _QUIET * usual:
                found.append(Run(first=place + 1, length=length, value=float(np.median(inside))))
    return found


def _usual(sizes: NDArray[np.float64]) -> float:
    """Return the standard deviation that a Gaussian of this median size has, by every seventh sample of many."""
    thinned = sizes[:: 7 if sizes.size > 70_000 else 1]
    if not sizes.size:
        return 0.0
    return float(np.median(thinned)) / 0.6745


def _smallest_step(values: NDArray[np.float64]) -> float:
    """Return the smallest step between two levels, where more than half of the samples do not move."""
    steps = np.abs(np.diff(values))
    return float(np.min(steps, where=steps > 0, initial=np.inf))
