"""The knobs that fit best: steps within a trust region, by derivatives kept up to date and seldom made anew."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.diagnosis.fitting.difference_quotients import Floats, Residuals, quotients

_RADIUS, _LEAST_RADIUS = 3.0, 0.02  # longest and shortest step
_RETRIED = 1.0  # length of a step that derivatives made anew are given at least
_SHORTENED, _LENGTHENED = 0.3, 2.0
_HELD = 0.25  # of the fall that the derivatives promise: less tells that the step was too long or they are stale
_TOLERANCE = 1e-3  # of the cost: a step that promises less is the last
_LITTLE = 0.8  # of the cost where derivatives were made: above it they are taken to hold
_FAR_LESS = 0.1  # times that for a step that does not hold what derivatives promise
_STILL = 1e-5  # length of a step that is none
_HALVINGS = 40
_REWEIGHTED = 3  # times a step, by the same derivatives


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
    bend: float = np.inf,
    jacobian: Floats | None = None,
    near: bool = True,
) -> Minimum:
    """Return where ``sum robust_square(residuals) + |positions|^2`` is least, within ``limit`` either way.

    A ``jacobian`` of the first knobs from an earlier fit tells which knobs share residuals; where that fit ended
    ``near`` the start, it saves making their derivatives at the beginning.

    Gauss-Newton steps on residuals that are reweighted within each step, no longer than a radius that shrinks where a
    step falls short of what the derivatives promise. Between fresh difference quotients, of which there are at most
    ``derivatives`` sets, the derivatives follow by Broyden's rank-one update; they are made anew where two steps in a
    row fall short, and where they promise no more after the cost has fallen far.

    Source: More and Sorensen 1983, SIAM J. Sci. Stat. Comput. 4(3); Broyden 1965, Math. Comp. 19; Holland and Welsch
    1977, Commun. Statist. A6 (the weights). Local: it finds the valley that ``start`` lies in.

    Parameters
    ----------
    residuals : callable
        From positions, shape (knobs,), to residuals in units of their spread.
    start : ndarray, shape (knobs,)
        In units of each knob's own spread.
    limit : float
        How far a knob may go from 0.
    derivatives : int
        Sets of difference quotients.
    bend : float
        Of ``robust_square``.
    jacobian : ndarray, shape (residuals, first knobs), or None
        Where None, every knob is stepped alone at first.
    near : bool
        Without a ``jacobian`` it changes nothing.
    """
    here = np.clip(start, -limit, limit)
    found = residuals(here)
    known = np.zeros((found.size, 0)) if jacobian is None else jacobian
    fresh = jacobian is None or not near
    slopes, made = quotients(residuals, here, found, known=known, kept=not fresh), int(fresh)
    cost = since = _cost(found, here, bend)
    radius, failed = _RADIUS, 0
    while radius > _LEAST_RADIUS:
        there = here + _move(slopes, found, here, radius=radius, limit=limit, bend=bend)
        moved = there - here
        length = float(np.linalg.norm(moved))
        if length < _STILL:
            break
        promised = cost - _cost(found + slopes @ moved, there, bend)
        new = residuals(there)
        fall = cost - _cost(new, there, bend)
        updated = slopes + np.outer(new - found - slopes @ moved, moved) / length**2
        held = fall > _HELD * promised
        failed = 0 if held else failed + 1
        radius = max(radius, min(_LENGTHENED * length, _RADIUS)) if held else _SHORTENED * length
        small = promised < _TOLERANCE * cost * (1.0 if held else _FAR_LESS)
        if fall > 0:
            here, found, cost, slopes = there, new, cost - fall, updated
        elif not fresh:
            slopes = updated
        was_fresh, fresh = fresh, fresh and fall <= 0
        if small and (was_fresh or cost > _LITTLE * since):
            break
        if not was_fresh and (small or failed > 1):
            if made >= derivatives:
                break
            slopes, made, fresh, failed = quotients(residuals, here, found, known=slopes), made + 1, True, 0
            since = cost
            radius = max(radius, _RETRIED)
    return Minimum(here, slopes, cost)


def robust_square(residuals: Floats, bend: float) -> Floats:
    """Return the square of each residual, growing no faster than linearly beyond ``bend`` (pseudo-Huber).

    ``2 b^2 (sqrt(1 + (r / b)^2) - 1)``: no single residual rules a fit.
    """
    return np.asarray(2 * residuals**2 / (1 + np.sqrt(1 + (residuals / bend) ** 2)))


def weights(residuals: Floats, bend: float) -> Floats:
    """Return by what each residual's square counts in a step towards the least ``robust_square``."""
    return np.asarray(1 / np.sqrt(1 + (residuals / bend) ** 2))


def _cost(found: Floats, here: Floats, bend: float) -> float:
    return float(robust_square(found, bend).sum() + here @ here)


def _move(slopes: Floats, found: Floats, here: Floats, *, radius: float, limit: float, bend: float) -> Floats:
    """Return the best step about as long as ``radius`` at most that leaves no knob beyond its limit.

    Residuals far off count by their size, so their weights follow the step that they are weighted for.
    """
    step = np.zeros(here.size)
    for _ in range(_REWEIGHTED):
        counted = weights(found + slopes @ step, bend)
        step = _weighted_move(slopes, found, here, counted, radius=radius, limit=limit)
    return step


def _weighted_move(
    slopes: Floats, found: Floats, here: Floats, counted: Floats, *, radius: float, limit: float
) -> Floats:
    """Return the same where each residual's square counts by ``counted``."""
    weighted = slopes * counted[:, None]
    gradient, curvature = weighted.T @ found + here, weighted.T @ slopes + np.eye(here.size)
    free = (np.abs(here) < limit) | (gradient * here > 0)
    step = np.zeros(here.size)
    for _ in range(here.size):
        bound = np.where(free, 0.0, step)
        step = bound.copy()
        step[free] = _within(radius, (gradient + curvature @ bound)[free], curvature[np.ix_(free, free)])
        beyond = free & (np.abs(here + step) > limit)
        if not beyond.any():
            break
        step[beyond] = np.sign(step[beyond]) * limit - here[beyond]
        free &= ~beyond
    return step


def _within(radius: float, gradient: Floats, curvature: Floats) -> Floats:
    """Return where ``gradient @ step + step @ curvature @ step / 2`` is least on steps no longer than ``radius``."""
    size, shape = np.linalg.eigh(curvature)
    along = shape.T @ gradient
    damping = 0.0
    if np.linalg.norm(along / size) > radius:
        low, high = 0.0, float(np.linalg.norm(along)) / radius
        for _ in range(_HALVINGS):
            damping = 0.5 * (low + high)
            low, high = (damping, high) if np.linalg.norm(along / (size + damping)) > radius else (low, damping)
    return np.asarray(-shape @ (along / (size + damping)))
