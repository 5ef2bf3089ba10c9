"""Least-squares fit of order lines to a signal, block by block, so that changing amplitudes are followed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

# fewest periods of a line in a block, to be separated from the load; highest line as a share of the sample rate
FEWEST_PERIODS, _HIGHEST_SHARE_OF_RATE = 2.0, 0.45
_RIDGE = 1e-9


def fitted_lines(
    values: NDArray[np.float64], angle: NDArray[np.float64], orders: Sequence[float], *, block: int
) -> NDArray[np.float64]:
    """Return the sum of the fitted lines a cos(n angle) + b sin(n angle), shape (samples,).

    In each block of ``block`` samples a and b are fitted together with a straight line per half block, which is not
    part of the result. Blocks overlap by half; a and b are linear from one block's middle to the next.

    Parameters
    ----------
    values, angle : ndarray, shape (samples,)
        The signal in any unit and the angle [rad]; the angle need not rise evenly.
    orders : sequence of float
        n [1/rev] of that angle; equal ones count once.
    block : int
        Samples per block, >= 4; a shorter signal is one block.

    Notes
    -----
    A line is not fitted in a block in which it has fewer than two periods, or exceeds 0.45 of the sample rate. The
    part of the load within about 1 / block of a line is fitted with it.
    """
    unique = tuple(sorted({float(f"{order:.9g}") for order in orders}))
    fitted = np.zeros_like(values)
    if not unique or values.size < 4:
        return fitted
    plan = _product_plan(unique)
    halves = max(2, round(2 * values.size / block))
    edges = np.linspace(0, values.size, halves + 1).astype(int)
    left = _segment(values, angle, plan, edges[0], edges[1])
    before: NDArray[np.float64] | None = None
    for index in range(1, halves):
        right = _segment(values, angle, plan, edges[index], edges[index + 1])
        after = _solved(left, right, unique)
        fitted[edges[index - 1] : edges[index]] = _blended(left, after if before is None else before, after)
        left, before = right, after
    if before is not None:
        fitted[edges[-2] :] = _blended(left, before, before)
    return fitted


@dataclass(frozen=True)
class _Segment:
    """Half a block: cosines and sines of its lines (rows), and their parts of the normal equations."""

    basis: NDArray[np.float64]
    gram: NDArray[np.float64]
    moment: NDArray[np.float64]
    turns: float
    fastest: float


def _segment(values: NDArray[np.float64], angle: NDArray[np.float64], plan: _Plan, start: int, stop: int) -> _Segment:
    theta, signal = angle[start:stop], values[start:stop]
    basis = _basis(theta, plan)
    straight = np.stack([np.ones(signal.size), np.linspace(-1.0, 1.0, signal.size)])
    straight /= np.sqrt((straight**2).sum(axis=1, keepdims=True))
    # the straight line is orthonormal, so projecting it out of both sides is one product each
    cross = basis @ straight.T
    gram = basis @ basis.T - cross @ cross.T
    moment = basis @ signal - cross @ (straight @ signal)
    steps = np.abs(np.diff(theta)) / (2 * np.pi)
    return _Segment(basis, gram, moment, float(steps.sum()), float(steps.max(initial=0.0)))


def _solved(left: _Segment, right: _Segment, orders: tuple[float, ...]) -> NDArray[np.float64]:
    """Return the coefficients of a block of two segments, shape (2 lines,); zero for lines that are not fitted."""
    each = np.array(orders)
    active = (each * (left.turns + right.turns) >= FEWEST_PERIODS) & (
        each * max(left.fastest, right.fastest) <= _HIGHEST_SHARE_OF_RATE
    )
    rows = np.flatnonzero(np.repeat(active, 2))
    coefficients = np.zeros(2 * each.size)
    if rows.size:
        gram = (left.gram + right.gram)[np.ix_(rows, rows)]
        gram += _RIDGE * np.trace(gram) / rows.size * np.eye(rows.size)
        coefficients[rows] = np.linalg.solve(gram, (left.moment + right.moment)[rows])
    return coefficients


def _blended(segment: _Segment, start: NDArray[np.float64], stop: NDArray[np.float64]) -> NDArray[np.float64]:
    size = segment.basis.shape[1]
    at_start, change = np.stack([start, stop - start]) @ segment.basis
    return np.asarray(at_start + change * ((np.arange(size) + 0.5) / size))


# a line's unit vector: from the angle where the second entry is None, else the product of two others
_Plan = tuple[tuple[float, tuple[int, int] | None], ...]


def _product_plan(orders: tuple[float, ...]) -> _Plan:
    """Return each order as a sum of two lower ones where possible, because a product is faster than a cosine."""
    plan: list[tuple[float, tuple[int, int] | None]] = []
    for index, order in enumerate(orders):
        pairs = (
            (i, j) for i in range(index) for j in range(i + 1) if abs(orders[i] + orders[j] - order) < 1e-9 * order
        )
        plan.append((order, next(pairs, None)))
    return tuple(plan)


def _basis(theta: NDArray[np.float64], plan: _Plan) -> NDArray[np.float64]:
    basis = np.empty((2 * len(plan), theta.size))
    vectors: list[NDArray[np.complex128]] = []
    for index, (order, pair) in enumerate(plan):
        vector = np.exp(1j * order * theta) if pair is None else vectors[pair[0]] * vectors[pair[1]]
        vectors.append(vector)
        basis[2 * index], basis[2 * index + 1] = vector.real, vector.imag
    return basis
