"""The compiled loops of the filters: cascades of biquads, their edge states, medians.

A cascade is run as a wavefront: section k works ``SKEW`` samples behind section k - 1, so that all sections of a step
are independent and fill the vector lanes; the buffers stay in the first-level cache. The operations and their order are
those of scipy's ``sosfilt`` and no two are contracted, so the sums round alike and the answers agree to the last bit.
"""

from __future__ import annotations

import numpy as np
from numba import njit

LANES = 24  # sections of one run; three vectors of eight, fewer are filled up with sections that do nothing
SKEW = 32  # samples between neighbouring sections: long enough that a store is done before it is read
_ROW = LANES + 8
SUMMED = {"reassoc", "contract", "nsz", "arcp"}


@njit(cache=True, nogil=True, error_model="numpy")
def _wavefront(before, after, w):
    """One block of ``SKEW`` steps of all lanes; ``w`` holds b0, b1, b2, a1, a2 and both states, ``LANES`` each."""
    for j in range(SKEW):
        for k in range(LANES):
            x = before[j * _ROW + k]
            y = w[k] * x + w[5 * LANES + k]
            w[5 * LANES + k] = (w[LANES + k] * x - w[3 * LANES + k] * y) + w[6 * LANES + k]
            w[6 * LANES + k] = w[2 * LANES + k] * x - w[4 * LANES + k] * y
            after[j * _ROW + k + 1] = y


@njit(cache=True, nogil=True, error_model="numpy")
def cascade(values, out, coefficients, states, backwards):
    """Run up to ``LANES`` sections over ``values`` into ``out`` (may be the same); ``states`` (2, sections) change.

    ``coefficients`` (5, sections) are b0, b1, b2, a1, a2; backwards starts at the last sample.
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
        if block < sections:  # lane `block` meets its first sample now
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
        if ended >= 0:  # lane `ended` has had its last whole block
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
def _one_section(values, out, size, coefficients, z1, z2):
    """Run one section from the states z1, z2 over ``size`` samples."""
    b0, b1, b2, a1, a2 = coefficients
    for i in range(size):
        x = values[i]
        y = b0 * x + z1
        z1, z2 = b1 * x - a1 * y + z2, b2 * x - a2 * y
        out[i] = y


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def _ringing_in(values, size, a1, a2):
    """Return what of a section's two free responses stands in ``values``: least squares beside a mean and a slope."""
    gram, moment, scale = np.zeros((4, 4)), np.zeros(4), np.zeros(4)
    p1, p2, q1, q2, slope = 1.0, 0.0, 0.0, 1.0, 2.0 / size
    for i in range(size):
        y, t = values[i], slope * i - 1.0
        moment[0] += p1 * y
        moment[1] += q1 * y
        moment[2] += y
        moment[3] += t * y
        gram[0, 0] += p1 * p1
        gram[0, 1] += p1 * q1
        gram[0, 2] += p1
        gram[0, 3] += p1 * t
        gram[1, 1] += q1 * q1
        gram[1, 2] += q1
        gram[1, 3] += q1 * t
        gram[2, 3] += t
        gram[3, 3] += t * t
        p1, p2 = p2 - a1 * p1, -a2 * p1
        q1, q2 = q2 - a1 * q1, -a2 * q1
    gram[2, 2] = size
    for m in range(4):
        scale[m] = 1.0 / np.sqrt(gram[m, m])
        for n in range(m):
            gram[m, n] = gram[n, m]
    solved = np.linalg.solve(gram * np.outer(scale, scale), moment * scale) * scale
    return solved[0], solved[1]


@njit(cache=True, nogil=True, error_model="numpy")
def quietest_states(values, coefficients, windows, given):
    """Return the states (2, sections) at the first sample for which each section's answer has the least energy.

    ``values`` is the edge, read forwards, and is overwritten; ``windows`` (sections,) are how much of it each section
    looks at, and 0 where the state is ``given`` (2, sections).
    """
    sections = coefficients.shape[1]
    states, answer = np.zeros((2, sections)), np.empty(values.size)
    for k in range(sections):
        if windows[k] == 0:
            states[:, k] = given[:, k]
        else:
            _one_section(values, answer, windows[k], coefficients[:, k], 0.0, 0.0)
            p, q = _ringing_in(answer, windows[k], coefficients[3, k], coefficients[4, k])
            states[0, k], states[1, k] = -p, -q
        needed = windows[k + 1 :].max() if k + 1 < sections else 0
        _one_section(values, values, max(needed, min(1, values.size)), coefficients[:, k], states[0, k], states[1, k])
    return states


@njit(cache=True, nogil=True, error_model="numpy")
def quieter_by(answer, coefficients, windows):
    """Return by how much the states (2, sections) must change so that ``answer``, the whole cascade's, rings less.

    Each section's free response is fitted to what the ones before have left of it; that the sections behind it alter
    the response a little is left to the next round. ``answer`` is overwritten.
    """
    change = np.zeros((2, coefficients.shape[1]))
    for k in range(coefficients.shape[1]):
        if windows[k] > 0:
            a1, a2 = coefficients[3, k], coefficients[4, k]
            p, q = _ringing_in(answer, windows[k], a1, a2)
            change[0, k], change[1, k] = -p, -q
            z1, z2 = -p, -q
            for i in range(windows[k]):
                answer[i] += z1
                z1, z2 = z2 - a1 * z1, -a2 * z1
    return change


@njit(cache=True, nogil=True, error_model="numpy")
def add_free_response(values, a1, a2, last, second_last):
    """Add to ``values`` how one section rings on after its last two samples."""
    for i in range(values.size):
        y = -a1 * last - a2 * second_last
        values[i] += y
        last, second_last = y, last


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def energy(values):
    """Return the sum of squares (a BLAS product would wake threads that spin)."""
    total = 0.0
    for i in range(values.size):
        total += values[i] * values[i]
    return total


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
