"""Compiled loops over the waves of lines."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numba import njit

from torquerig.simulation.kernel.elementary import sine_cosine
from torquerig.simulation.kernel.fast import FAST
from torquerig.simulation.kernel.sources import sources_key


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
