"""Stretches of a recording that are each evenly sampled, at different rates."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

# steps of which the middle one is taken: one lost sample or a few late times do not change it [1]
_MIDDLE_OF = 15
# smallest difference of two rates that is a change: clocks drift by less [1]
_CHANGE = 0.01
# share of the steps of a stretch that are its usual one within the tolerance [1]
_EVEN, _TOLERANCE = 0.9, 0.005
# a stretch with fewer steps is no change of rate but a few odd samples [1]
_SHORTEST = 2 * _MIDDLE_OF
# with more stretches the clock is uneven, and no rate is worth naming [1]
_MOST = 8


@dataclass(frozen=True)
class Stretch:
    """Samples ``first`` to ``last`` at one ``rate`` [Hz]."""

    first: int
    last: int
    rate: float


def stretches_of_rates(times: NDArray[np.float64]) -> tuple[Stretch, ...]:
    """Return the stretches of rising ``times`` [s], shape (samples,), at two or more steady rates; else nothing."""
    steps = np.diff(times)
    if steps.size < 2 * _SHORTEST:
        return ()
    blocks = steps[: steps.size // _MIDDLE_OF * _MIDDLE_OF].reshape(-1, _MIDDLE_OF)
    middles = np.median(blocks, axis=1)
    changes = np.flatnonzero(np.abs(np.diff(middles)) > _CHANGE * middles[:-1]) + 1
    edges = np.concatenate([[0], changes, [middles.size]])
    runs = [(int(one), int(two)) for one, two in pairwise(edges) if two - one >= 2]
    if not 2 <= len(runs) <= _MOST:
        return ()
    usual = [float(np.median(steps[one * _MIDDLE_OF : two * _MIDDLE_OF])) for one, two in runs]
    if min(usual) <= 0 or max(usual) < (1 + _CHANGE) * min(usual):
        return ()
    ends = [0, *(_change_at(steps, runs, usual, number) for number in range(len(runs) - 1)), steps.size]
    found = []
    for first, last, step in zip(ends[:-1], ends[1:], usual, strict=True):
        within = np.abs(steps[first:last] / step - 1) < _TOLERANCE
        if last - first < _SHORTEST or np.count_nonzero(within) < _EVEN * (last - first):
            return ()
        found.append(Stretch(first, last, 1 / float(np.mean(steps[first:last][within]))))
    return tuple(found)


def _change_at(steps: NDArray[np.float64], runs: list[tuple[int, int]], usual: list[float], number: int) -> int:
    """Return the first step that is nearer to the usual one of the later run, where the two runs meet."""
    low, high = (runs[number][1] - 1) * _MIDDLE_OF, (runs[number + 1][0] + 1) * _MIDDLE_OF
    middle = (usual[number] * usual[number + 1]) ** 0.5
    later = (steps[low:high] < middle) == (usual[number + 1] < middle)
    # the place at which the fewest steps are on the wrong side
    wrong = np.concatenate([[0], np.cumsum(later)]) + np.concatenate([np.cumsum(~later[::-1])[::-1], [0]])
    return low + int(np.argmin(wrong))
