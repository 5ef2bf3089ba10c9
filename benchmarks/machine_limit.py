"""The peak floating-point rate and the memory bandwidth of one core, as a small compiled loop reaches them.

Peak: chains of 16 fused multiply-adds y = y x + c on 1024 numbers, which stay in the first cache; the compiler makes
vectors of them, and the processor has enough independent chains to fill its pipes. A fused multiply-add counts as two
operations. Bandwidth: the triad a = b + s c of J. D. McCalpin's STREAM (1995), on three arrays that are each larger
than the last cache; three numbers count for each element, as there. Both take the least of several turns.
Run: python benchmarks/machine_limit.py
"""

from __future__ import annotations

import time

import numpy as np
from numba import njit

NUMBERS, CHAIN, ROUNDS = 1024, 16, 20_000
TRIAD, TURNS = 16_000_000, 7  # numbers of each array: 128 MB


@njit(cache=True, fastmath={"contract"}, error_model="numpy")
def _multiply_add(y, x, c, rounds):
    """Apply 16 fused multiply-adds to each number of ``y``, so many times."""
    for _ in range(rounds):
        for n in range(y.size):
            v, f = y[n], x[n]
            v = ((v * f + c) * f + c) * f + c
            v = ((v * f + c) * f + c) * f + c
            v = ((v * f + c) * f + c) * f + c
            v = ((v * f + c) * f + c) * f + c
            v = ((v * f + c) * f + c) * f + c
            y[n] = v * f + c


@njit(cache=True, error_model="numpy")
def _triad(a, b, c, s):
    for n in range(a.size):
        a[n] = b[n] + s * c[n]


def peak_rate() -> float:
    """Return the operations per second of one core [1/s]."""
    y, x = np.ones(NUMBERS), np.full(NUMBERS, 0.5)
    _multiply_add(y, x, 0.1, 10)
    least = min(_spent(_multiply_add, y, x, 0.1, ROUNDS) for _ in range(TURNS))
    return 2 * CHAIN * NUMBERS * ROUNDS / least


def bandwidth() -> float:
    """Return the bytes per second of one core [B/s]."""
    a, b, c = (np.full(TRIAD, value) for value in (0.0, 1.0, 2.0))
    _triad(a[:10], b[:10], c[:10], 3.0)
    least = min(_spent(_triad, a, b, c, 3.0) for _ in range(TURNS))
    return 3 * 8 * TRIAD / least


def _spent(function, *arguments) -> float:
    start = time.process_time()
    function(*arguments)
    return time.process_time() - start


if __name__ == "__main__":
    print(f"{peak_rate() / 1e9:.1f} Gflop/s, {bandwidth() / 1e9:.1f} GB/s of one core")
