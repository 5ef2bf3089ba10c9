"""The knobs that fit best: damped Gauss-Newton steps whose derivatives are kept up to date and seldom made anew."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Residuals = Callable[[Floats], Floats]

_STEP = 1e-6  # of the difference quotients
_DAMPING, _EASED, _RAISED, _MOST_DAMPING = 1e-3, 0.2, 8.0, 1e5
_CONVERGED = 1e-3  # relative fall of the cost below which a step with fresh derivatives is the last
_STALE = 2e-2  # relative fall of the cost below which kept derivatives are made anew


@dataclass(frozen=True)
class Minimum:
    """Positions, shape (knobs,), the derivatives of the residuals there, shape (residuals, knobs), and the cost."""

    positions: Floats
    jacobian: Floats
    cost: float


def minimum(
    residuals: Residuals, start: Floats, *, limit: float, derivatives: int, jacobian: Floats | None = None
) -> Minimum:
    """Return where ``|residuals|^2 + |positions|^2`` is least, within ``limit`` either way.

    A ``jacobian`` of the first knobs, known from an earlier fit near ``start``, saves making theirs at the beginning.

    Levenberg-Marquardt steps; between fresh difference quotients, of which there are at most ``derivatives`` sets, the
    derivatives follow by Broyden's rank-one update.

    Source: Marquardt 1963, SIAM J. Appl. Math. 11; Broyden 1965, Math. Comp. 19. Local: it finds the valley that
    ``start`` lies in.
    """
    here, found = np.clip(start, -limit, limit), None
    found = residuals(here)
    kept = 0 if jacobian is None else jacobian.shape[1]
    slopes, made, fresh = _slopes(residuals, here, found, first=kept), int(kept == 0), kept == 0
    if jacobian is not None:
        slopes[:, :kept] = jacobian
    cost, damping = _cost(found, here), _DAMPING
    while damping < _MOST_DAMPING:
        there = np.clip(here + _move(slopes, found, here, damping=damping, limit=limit), -limit, limit)
        new = residuals(there)
        fall = cost - _cost(new, there)
        moved = there - here
        length = float(moved @ moved)
        if length == 0.0:
            break
        updated = slopes + np.outer(new - found - slopes @ moved, moved) / length
        if fall > 0:
            done = fall < (_CONVERGED if fresh else _STALE) * cost
            here, found, cost, damping = there, new, cost - fall, max(damping * _EASED, 1e-6)
            slopes, was_fresh, fresh = updated, fresh, False
            if not done:
                continue
            if was_fresh or made >= derivatives:
                break
        elif fresh:
            damping *= _RAISED
            continue
        elif made >= derivatives:
            break
        slopes, made, fresh = _slopes(residuals, here, found), made + 1, True
    return Minimum(here, slopes, cost)


def _cost(found: Floats, here: Floats) -> float:
    return float(found @ found + here @ here)


def _slopes(residuals: Residuals, here: Floats, found: Floats, *, first: int = 0) -> Floats:
    """Return the difference quotients of the knobs from ``first`` on, the columns before left 0."""
    answer = np.zeros((found.size, here.size))
    for column in range(first, here.size):
        beside = here.copy()
        beside[column] += _STEP if here[column] <= 0 else -_STEP
        answer[:, column] = (residuals(beside) - found) / (beside[column] - here[column])
    return answer


def _move(slopes: Floats, found: Floats, here: Floats, *, damping: float, limit: float) -> Floats:
    """Return the step; knobs that stand at their limit and want beyond it stay."""
    gradient = slopes.T @ found + here
    free = (np.abs(here) < limit) | (gradient * here > 0)
    curvature = slopes[:, free].T @ slopes[:, free] + np.eye(int(free.sum()))
    step = np.zeros(here.size)
    step[free] = -np.linalg.solve(curvature + damping * np.diag(np.diag(curvature)), gradient[free])
    return step
