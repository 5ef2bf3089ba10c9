"""Compiled Monte Carlo sampling of a whole matrix: totals, and how often each alternative takes each rank.

Every random number is a hash of a key and the number of the sample (SplitMix64: Steele, Lea and Flood, Fast splittable
pseudorandom number generators, OOPSLA 2014). So each cell and weight has a separate
stream, independent of all others, and threads may share the samples. The loops run over blocks of samples so that
these stay in the cache and the compiler can vectorise them.
"""

from __future__ import annotations

import numpy as np
from numba import njit

BLOCK = 256
_GOLDEN = np.uint64(0x9E3779B97F4A7C15)
_FIRST = np.uint64(0xBF58476D1CE4E5B9)
_SECOND = np.uint64(0x94D049BB133111EB)
_ONE = np.uint64(0x3FF0000000000000)
_LOW = np.uint64(0xFFFFFFFF)


@njit(cache=True, nogil=True, inline="always")
def _fill(upper, lower, key, first, count):
    """Write two uniforms as bit patterns of doubles in 1..2, from 32 bits of the hash each."""
    for at in range(count):
        number = key + _GOLDEN * np.uint64(first + at)
        number = (number ^ (number >> np.uint64(30))) * _FIRST
        number = (number ^ (number >> np.uint64(27))) * _SECOND
        number = number ^ (number >> np.uint64(31))
        upper[at] = ((number >> np.uint64(32)) << np.uint64(20)) | _ONE
        lower[at] = ((number & _LOW) << np.uint64(20)) | _ONE


@njit(cache=True, nogil=True)
def _draw(first, count, cells, weights, scale, totals, whole, drawn, upper, lower, value, points):
    """Fill ``totals`` (alternatives, BLOCK) and ``whole`` (BLOCK,), the sums of the weights, for one block."""
    keys, start, width, logarithmic, base, slope, knots, turns, bends, half_widths = cells
    given, weight_keys, weight_half_widths = weights
    rows, columns = start.shape
    u, score = upper.view(np.float64), lower.view(np.float64)
    whole[:count] = 0.0
    for column in range(columns):
        drawn[column, :count] = given[column]
        if weight_half_widths[column] > 0:
            _fill(upper, lower, weight_keys[column], first, count)
            for at in range(count):
                drawn[column, at] = given[column] * (1.0 + weight_half_widths[column] * (2.0 * u[at] - 3.0))
        for at in range(count):
            whole[at] += drawn[column, at]
    for row in range(rows):
        totals[row, :count] = 0.0
        for column in range(columns):
            reach, wide = half_widths[row, column], width[row, column]
            if wide > 0 or reach > 0:
                _fill(upper, lower, keys[row, column], first, count)
            if wide > 0:
                origin, level, steep = start[row, column], base[row, column], slope[row, column]
                for at in range(count):
                    value[at] = origin + wide * (u[at] - 1.0)
                if logarithmic[row, column]:
                    for at in range(count):
                        value[at] = np.exp(value[at])
                for at in range(count):
                    points[at] = level + steep * value[at]
                for bend in range(bends[row, column]):
                    knot, turn = knots[row, column, bend], turns[row, column, bend]
                    for at in range(count):
                        over = value[at] - knot
                        points[at] += turn * (over if over > 0.0 else 0.0)
            else:
                points[:count] = base[row, column]
            if reach > 0:
                floor, ceiling = scale[0], scale[1]
                for at in range(count):
                    one = points[at] + reach * (2.0 * score[at] - 3.0)
                    one = one if one > floor else floor
                    points[at] = one if one < ceiling else ceiling
            for at in range(count):
                totals[row, at] += drawn[column, at] * points[at]


@njit(cache=True, nogil=True)
def count_ranks(first, draws, cells, weights, scale, tie, counts, sums):
    """Add samples ``first .. first + draws`` to ``counts`` (alternatives, ranks) and ``sums`` (alternatives,).

    ``cells`` holds, by alternative and criterion: key; start and width of the value (of its logarithm where
    ``logarithmic``); the points as ``base + slope v + sum of turns max(0, v - knots)`` over ``bends`` knots; and the
    half-width of the error of the points, which stay within ``scale``. ``weights`` holds the given ones, their keys
    and relative half-widths. ``sums`` adds up T over the sum of the weights. A tie shares its ranks equally.
    """
    rows, columns = cells[1].shape
    upper, lower = np.empty(BLOCK, np.uint64), np.empty(BLOCK, np.uint64)
    value, points, whole = np.empty(BLOCK), np.empty(BLOCK), np.empty(BLOCK)
    drawn, totals = np.empty((columns, BLOCK)), np.empty((rows, BLOCK))
    above = np.empty((rows, BLOCK), np.int64)
    for block in range(first, first + draws, BLOCK):
        count = min(BLOCK, first + draws - block)
        _draw(block, count, cells, weights, scale, totals, whole, drawn, upper, lower, value, points)
        for row in range(rows):
            share = 0.0
            for at in range(count):
                share += totals[row, at] / whole[at]
            sums[row] += share
        above[:, :count] = 0
        for row in range(rows):
            for other in range(row):
                for at in range(count):
                    lead = totals[other, at] - totals[row, at]
                    above[row, at] += 1 if lead > tie else 0
                    above[other, at] += 1 if lead < -tie else 0
        for at in range(count):
            places = 0
            for row in range(rows):
                places += above[row, at]
            if places == rows * (rows - 1) // 2:
                for row in range(rows):
                    counts[row, above[row, at]] += 1.0
                continue
            for row in range(rows):
                same = 0
                for other in range(rows):
                    same += 1 if abs(totals[other, at] - totals[row, at]) <= tie else 0
                for place in range(above[row, at], above[row, at] + same):
                    counts[row, place] += 1.0 / same


@njit(cache=True, nogil=True)
def all_totals(draws, cells, weights, scale, out):
    """Write T of every sample into ``out`` (alternatives, draws), for checks and pictures."""
    rows, columns = cells[1].shape
    upper, lower = np.empty(BLOCK, np.uint64), np.empty(BLOCK, np.uint64)
    value, points, whole = np.empty(BLOCK), np.empty(BLOCK), np.empty(BLOCK)
    drawn, totals = np.empty((columns, BLOCK)), np.empty((rows, BLOCK))
    for block in range(0, draws, BLOCK):
        count = min(BLOCK, draws - block)
        _draw(block, count, cells, weights, scale, totals, whole, drawn, upper, lower, value, points)
        out[:, block : block + count] = totals[:, :count]
