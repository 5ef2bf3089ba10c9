"""The knobs that fit best: damped Gauss-Newton steps whose derivatives are kept up to date and seldom made anew."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.diagnose.difference_quotients import Floats, Residuals, quotients

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
    residuals: Residuals,
    start: Floats,
    *,
    limit: float,
    derivatives: int,
    jacobian: Floats | None = None,
    near: bool = True,
) -> Minimum:
    """Return where ``|residuals|^2 + |positions|^2`` is least, within ``limit`` either way.

    A ``jacobian`` of the first knobs from an earlier fit tells which knobs share residuals; where that fit ended
    ``near`` the start, it saves making their derivatives at the beginning.

    Levenberg-Marquardt steps; between fresh difference quotients, of which there are at most ``derivatives`` sets, the
    derivatives follow by Broyden's rank-one update.

    Source: Marquardt 1963, SIAM J. Appl. Math. 11; Broyden 1965, Math. Comp. 19. Local: it finds the valley that
    ``start`` lies in.
    """
    here = np.clip(start, -limit, limit)
    found = residuals(here)
    known = np.zeros((found.size, 0)) if jacobian is None else jacobian
    fresh = jacobian is None or not near
    slopes, made = quotients(residuals, here, found, known=known, kept=not fresh), int(fresh)
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
        slopes, made, fresh = quotients(residuals, here, found, known=slopes), made + 1, True
    return Minimum(here, slopes, cost)


def _cost(found: Floats, here: Floats) -> float:
    return float(found @ found + here @ here)


def _move(slopes: Floats, found: Floats, here: Floats, *, damping: float, limit: float) -> Floats:
    """Return the step; knobs that stand at their limit and want beyond it stay."""
    gradient = slopes.T @ found + here
    free = (np.abs(here) < limit) | (gradient * here > 0)
    curvature = slopes[:, free].T @ slopes[:, free] + np.eye(int(free.sum()))
    step = np.zeros(here.size)
    step[free] = -np.linalg.solve(curvature + damping * np.diag(np.diag(curvature)), gradient[free])
    return step
