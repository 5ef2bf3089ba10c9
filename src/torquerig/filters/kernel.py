"""The compiled loops of the filters: cascades of biquads, the lines at their edges, medians.

A cascade is computed as a wavefront: section k works ``SKEW`` samples behind section k - 1, so that all sections of a
step are independent and vectorised; the buffers fit into the first-level cache. Operations and their order are those
of scipy's ``sosfilt`` without contraction, so that the results agree to the last bit.
"""

from __future__ import annotations

import numpy as np
from numba import njit

LANES = 24  # sections of one run: three vectors of eight; unused lanes are filled with zeros
SKEW = 32  # samples between neighbouring sections, long enough for a store to finish before it is read
_ROW = LANES + 8


@njit(cache=True, nogil=True, error_model="numpy")
def _wavefront(before, after, w):
    """Compute ``SKEW`` steps of all lanes; ``w`` holds b0, b1, b2, a1, a2 and both states, ``LANES`` each."""
    for j in range(SKEW):
        for k in range(LANES):
            x = before[j * _ROW + k]
            y = w[k] * x + w[5 * LANES + k]
            w[5 * LANES + k] = (w[LANES + k] * x - w[3 * LANES + k] * y) + w[6 * LANES + k]
            w[6 * LANES + k] = w[2 * LANES + k] * x - w[4 * LANES + k] * y
            after[j * _ROW + k + 1] = y


@njit(cache=True, nogil=True, error_model="numpy")
def cascade(values, out, coefficients, states, backwards):
    """Filter ``values`` into ``out`` (may be the same) by up to ``LANES`` sections; ``states`` (2, sections) change.

    ``coefficients`` (5, sections) are b0, b1, b2, a1, a2; ``backwards`` starts at the last sample.
    """
    sections, size = coefficients.shape[1], values.size
    w = np.zeros(7 * LANES)
    for k in range(sections):
        for i in range(5):
            w[i * LANES + k] = coefficients[i, k]
    before, after = np.zeros(SKEW * _ROW), np.zeros(SKEW * _ROW)
    start, step = (size - 1, -1) if backwards else (0, 1)
    blocks = size // SKEW
    for block in range(blocks + sections - 1 if blocks else 0):
        if block < sections:  # lane `block` gets its first sample here
            w[5 * LANES + block], w[6 * LANES + block] = states[0, block], states[1, block]
        if block < blocks:
            at = start + step * block * SKEW
            for j in range(SKEW):
                before[j * _ROW] = values[at + step * j]
        _wavefront(before, after, w)
        ready = block - sections + 1
        if ready >= 0:
            at = start + step * ready * SKEW
            for j in range(SKEW):
                out[at + step * j] = after[j * _ROW + sections]
        ended = block - blocks + 1
        if ended >= 0:  # lane `ended` has finished its last complete block
            states[0, ended], states[1, ended] = w[5 * LANES + ended], w[6 * LANES + ended]
        before, after = after, before
    for i in range(blocks * SKEW, size):
        x = values[start + step * i]
        for k in range(sections):
            y = coefficients[0, k] * x + states[0, k]
            states[0, k] = (coefficients[1, k] * x - coefficients[3, k] * y) + states[1, k]
            states[1, k] = coefficients[2, k] * x - coefficients[4, k] * y
            x = y
        out[start + step * i] = x


@njit(cache=True, nogil=True, error_model="numpy")
def turned_back(values, first, size, angle):
    """Return twice the Hann-weighted mean of ``size`` values from ``first``, demodulated by ``angle`` [rad/sample].

    A line cos(angle n + phase) gives its complex amplitude at sample 0.
    """
    total = 0.0 + 0.0j
    unit, turn = np.exp(-1j * angle * first), np.exp(-1j * angle)
    window, step = np.exp(1j * np.pi / size), np.exp(2j * np.pi / size)
    for i in range(size):
        total += (1.0 - window.real) * values[first + i] * unit
        unit *= turn
        window *= step
    return 2.0 * total / size


@njit(cache=True, nogil=True, error_model="numpy")
def take_line(values, size, amplitude, angle):
    """Subtract the line of a complex amplitude from the first ``size`` values."""
    unit, turn = amplitude, np.exp(1j * angle)
    for i in range(size):
        values[i] -= unit.real
        unit *= turn


@njit(cache=True, nogil=True, error_model="numpy")
def add_free_response(values, a1, a2, last, second_last):
    """Add to ``values`` the free response of one section after its last two samples."""
    for i in range(values.size):
        y = -a1 * last - a2 * second_last
        values[i] += y
        last, second_last = y, last


@njit(cache=True, nogil=True, error_model="numpy")
def _sort(values):
    """Sort a short array in place."""
    for i in range(1, values.size):
        value, j = values[i], i
        while j > 0 and values[j - 1] > value:
            values[j] = values[j - 1]
            j -= 1
        values[j] = value


@njit(cache=True, nogil=True, error_model="numpy")
def medians(values, half):
    """Return the median around each sample, and the median distance from it, over ``2 half + 1`` samples inside."""
    size = values.size
    width = min(2 * half + 1, size)
    median, distance, near = np.empty(size), np.empty(size), np.empty(width)
    for i in range(size):
        first = min(max(i - half, 0), size - width)
        near[:] = values[first : first + width]
        _sort(near)
        median[i] = near[width // 2]
        for j in range(width):
            near[j] = abs(near[j] - median[i])
        _sort(near)
        distance[i] = near[width // 2]
    return median, distance
