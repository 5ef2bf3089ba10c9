"""Compiled loops of what is looked for in recordings."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from torquerig.simulation.kernel.elementary import sine_cosine
from torquerig.simulation.kernel.fast import FAST
from torquerig.simulation.kernel.sources import sources_key


@njit(cache=True, nogil=True)
def largest_path_sum(values: NDArray[np.float64], far: int) -> tuple[float, int, int]:
    """Return the largest sum along a straight path from the first row to the last, and the columns of its ends.

    Parameters
    ----------
    values : ndarray, shape (rows, columns)
    far : int
        Columns by which the ends of a path differ at least.
    """
    rows, columns = values.shape
    best, first, last = -np.inf, 0, 0
    for start in range(columns):
        for stop in range(columns):
            if abs(stop - start) < far:
                continue
            slope, total = (stop - start) / (rows - 1), 0.0
            for row in range(rows):
                total += values[row, int(start + slope * row + 0.5)]
            if total > best:
                best, first, last = total, start, stop
    return best, first, last


def _built(key: int) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """Return the compiled loops over waves; ``key`` is closed over so that the cache on disk is keyed by the sine."""

    @njit(cache=True, nogil=True, fastmath=FAST)
    def weighted_waves(rate, turning, angle, time, weight, answer):
        lines = rate.size if key >= 0 else 0
        for row in range(lines):
            along = angle if turning[row] else time
            for at in range(weight.size):
                sine, cosine = sine_cosine(rate[row] * along[at])
                answer[row, at] = weight[at] * cosine
                answer[lines + row, at] = -weight[at] * sine

    @njit(cache=True, nogil=True, fastmath=FAST)
    def summed_waves(rate, turning, angle, time, real, imaginary, answer):
        lines = rate.size if key >= 0 else 0
        for row in range(lines):
            along = angle if turning[row] else time
            for at in range(answer.size):
                sine, cosine = sine_cosine(rate[row] * along[at])
                answer[at] += real[row] * cosine - imaginary[row] * sine

    return weighted_waves, summed_waves


weighted_waves, summed_waves = _built(sources_key())
