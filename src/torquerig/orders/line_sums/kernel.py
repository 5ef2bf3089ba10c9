"""Compiled loops over order lines: unit vectors, sums, lines added to a signal, adaptive cancelling."""

from __future__ import annotations

import numpy as np
from numba import njit

BLOCK = 512  # samples per block: smaller ones cost function calls, larger ones leave the fast caches
SUMMED = {"reassoc", "contract", "nsz", "arcp"}


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def _multiplied(c1, s1, c2, s2, cosine, sine, size):
    """Multiply two unit vectors as complex numbers; separate rows, so that the loop is vectorised."""
    for n in range(size):
        cosine[n] = c1[n] * c2[n] - s1[n] * s2[n]
        sine[n] = s1[n] * c2[n] + c1[n] * s2[n]


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def _by_polynomials(turns, order, cosine, sine):
    """Fill cosine and sine of ``order`` times the turned angle, to 1e-12."""
    for n in range(turns.size):
        cycles = order * turns[n]
        t = np.pi * (cycles - np.floor(cycles + 0.5))  # half the angle, within a quarter turn
        q = t * t
        s = 1 - q / 110 * (1 - q / 156 * (1 - q / 210 * (1 - q / 272)))
        s = t * (1 - q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * s))))
        c = 1 - q / 90 * (1 - q / 132 * (1 - q / 182 * (1 - q / 240)))
        c = 1 - q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56 * c)))
        cosine[n] = 1 - 2 * s * s
        sine[n] = 2 * s * c


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def unit_vectors(turns, start, stop, orders, first, second, cosine, sine):
    """Fill cosine and sine (orders, BLOCK) of each order times the turned angle, by products (``ladder_of``)."""
    for k in range(orders.size):
        if first[k] >= 0:
            _multiplied(
                cosine[first[k]], sine[first[k]], cosine[second[k]], sine[second[k]], cosine[k], sine[k], stop - start
            )
        else:
            _by_polynomials(turns[start:stop], orders[k], cosine[k], sine[k])


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def summed(values, offset, turns, edges, orders, first, second):
    """Return sum of (values - offset) times cos and sin of each order over each hop, shape (2, orders, hops)."""
    sums = np.zeros((2, orders.size, edges.size - 1))
    cosine, sine = np.empty((orders.size, BLOCK)), np.empty((orders.size, BLOCK))
    piece = np.empty(BLOCK)
    for hop in range(edges.size - 1):
        for start in range(edges[hop], edges[hop + 1], BLOCK):
            stop = min(start + BLOCK, edges[hop + 1])
            unit_vectors(turns, start, stop, orders, first, second, cosine, sine)
            for n in range(stop - start):
                piece[n] = values[start + n] - offset
            for k in range(orders.size):
                c, s = cosine[k], sine[k]
                in_phase, quadrature = 0.0, 0.0
                for n in range(stop - start):
                    in_phase += piece[n] * c[n]
                    quadrature += piece[n] * s[n]
                sums[0, k, hop] += in_phase
                sums[1, k, hop] += quadrature
    return sums


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def put_in(out, turns, edges, orders, first, second, amplitudes, gain):
    """Add ``gain`` times the lines to ``out``; ``amplitudes`` (2, orders, hops + 1) are linear between the edges."""
    cosine, sine = np.empty((orders.size, BLOCK)), np.empty((orders.size, BLOCK))
    block = np.empty(BLOCK)
    for hop in range(edges.size - 1):
        width = edges[hop + 1] - edges[hop]
        for start in range(edges[hop], edges[hop + 1], BLOCK):
            stop = min(start + BLOCK, edges[hop + 1])
            unit_vectors(turns, start, stop, orders, first, second, cosine, sine)
            block[:] = 0.0
            for k in range(orders.size):
                slope_a = gain * (amplitudes[0, k, hop + 1] - amplitudes[0, k, hop]) / width
                slope_b = gain * (amplitudes[1, k, hop + 1] - amplitudes[1, k, hop]) / width
                a = gain * amplitudes[0, k, hop] + slope_a * (start - edges[hop])
                b = gain * amplitudes[1, k, hop] + slope_b * (start - edges[hop])
                c, s = cosine[k], sine[k]
                for n in range(stop - start):
                    block[n] += (a + slope_a * n) * c[n] + (b + slope_b * n) * s[n]
            for n in range(stop - start):
                out[start + n] += block[n]


@njit(cache=True, nogil=True, error_model="numpy")
def _sinc_of_pair(si, ci, sj, cj, half):
    """Return sin(x) / x of x = half, from sines and cosines of its two summands."""
    return (si * cj + ci * sj) / half if abs(half) > 1e-6 else 1.0


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def products(middle, width, size, orders):
    """Return the sums over hops of cos and sin of all sums and differences of orders, shape (4, orders, orders).

    Rows: cos and sin of the sums, cos and sin of the differences. In a hop of ``size`` samples the speed is taken as
    constant; it turns by ``width`` around ``middle`` [turns].
    """
    count = orders.size
    total = np.zeros((4, count, count))
    c, s, cw, sw = np.empty(count), np.empty(count), np.empty(count), np.empty(count)
    for hop in range(middle.size):
        for k in range(count):
            angle = 2 * np.pi * orders[k] * middle[hop]
            half = np.pi * orders[k] * width[hop]
            c[k], s[k], cw[k], sw[k] = np.cos(angle), np.sin(angle), np.cos(half), np.sin(half)
        for i in range(count):
            for j in range(i + 1):
                up = np.pi * (orders[i] + orders[j]) * width[hop]
                down = np.pi * (orders[i] - orders[j]) * width[hop]
                plus = size[hop] * _sinc_of_pair(sw[i], cw[i], sw[j], cw[j], up)
                minus = size[hop] * _sinc_of_pair(sw[i], cw[i], -sw[j], cw[j], down)
                total[0, i, j] += plus * (c[i] * c[j] - s[i] * s[j])
                total[1, i, j] += plus * (s[i] * c[j] + c[i] * s[j])
                total[2, i, j] += minus * (c[i] * c[j] + s[i] * s[j])
                total[3, i, j] += minus * (s[i] * c[j] - c[i] * s[j])
    for i in range(count):
        for j in range(i):
            total[0, j, i], total[1, j, i] = total[0, i, j], total[1, i, j]
            total[2, j, i], total[3, j, i] = total[2, i, j], -total[3, i, j]
    return total


@njit(cache=True, nogil=True, error_model="numpy", fastmath=SUMMED)
def cancelled(values, turns, orders, first, second, step):
    """Return the values less the prediction of adaptive amplitudes of the orders, updated by ``step`` per error (LMS).

    The residual is the mean of the errors before and after the update, so that the gain at 0 Hz is 1.
    """
    size, count = values.size, orders.size
    residual = np.empty(size)
    cosine, sine = np.empty((count, BLOCK)), np.empty((count, BLOCK))
    a, b = np.zeros(count), np.zeros(count)
    for start in range(0, size, BLOCK):
        stop = min(start + BLOCK, size)
        unit_vectors(turns, start, stop, orders, first, second, cosine, sine)
        for n in range(stop - start):
            predicted = 0.0
            for k in range(count):
                predicted += a[k] * cosine[k, n] + b[k] * sine[k, n]
            error = values[start + n] - predicted
            residual[start + n] = error * (1 - 0.5 * step * count)
            for k in range(count):
                a[k] += step * error * cosine[k, n]
                b[k] += step * error * sine[k, n]
    return residual
