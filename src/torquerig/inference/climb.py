"""Climb to the maximum of the posterior of a model's parameters, the sizes of the discrepancy held."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.data import Data, all_residuals
from torquerig.inference.knobs import Knob, turned
from torquerig.inference.likelihood import Discrepancy, Residuals, log_density_of
from torquerig.inference.moved_gain import residuals_with_moved_gain
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run
from torquerig.inference.slopes import gradient_of, hessian_of, row_weights, stacked
from torquerig.parallel import parallel_map
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

_STEP = 0.05  # [standard deviations] of a difference quotient
_RADIUS = 4.0  # [standard deviations] longest step at first
_SHORTEST = 1e-3  # [standard deviations] a shorter step ends the search
_SMALL_GAIN = 0.02  # [nats] a smaller one ends the search
_FALLEN_SHORT = 0.25  # share of the promised gain below which a step was too long
_FAR = 0.1  # [1] of the logarithm of a number: what goes with its square then changes by a fifth
_MANY = 12  # parameters whose derivatives take longer than a second process to start
_NOTHING = 1e-300
_BAD = -1e12  # [nats] of a rig that cannot be


@dataclass(frozen=True, eq=False)
class Case:
    """What stays the same while a fit moves."""

    rig: Rig
    knobs: tuple[Knob, ...]
    data: Data
    off: Discrepancy

    def expected(self, positions: Floats) -> list[ExpectedRun] | None:
        """Return what the model expects of each run; None where such a rig cannot be."""
        try:
            at = turned(self.rig, self.knobs, positions)
            return [expected_run(at, seen) for seen in self.data.seen]
        except (TorquerigError, ValueError, OverflowError, np.linalg.LinAlgError):
            return None


@dataclass(frozen=True, eq=False)
class Point:
    """Where a fit is: parameters, gains and what the model expects there; when it is reached, derivatives and score.

    ``made`` are the parameters and gains at which all derivatives were made, None where some are of another fit.
    """

    positions: Floats
    gains: Floats
    expected: Sequence[ExpectedRun]
    slopes: Floats = field(default_factory=lambda: np.zeros((0, 0)))
    value: Floats = field(default_factory=lambda: np.zeros(0))
    sd: Floats = field(default_factory=lambda: np.zeros(0))
    score: float = 0.0
    made: Floats | None = None


def climbed(
    at: Case, start: Point, iterations: int, *, jacobian: Floats | None = None, rest: float = 0.0
) -> Point:  # fmt: skip
    """Return the maximum of the posterior that a start leads to; ``rest`` as of ``followed``.

    Derivatives are made at the start, where ``jacobian`` has finite columns those of it are taken.
    """
    slopes = slopes_at(at, start, kept=jacobian)
    made = np.concatenate([start.positions, start.gains]) if jacobian is None else None
    kept = np.zeros(slopes.shape[1], dtype=bool) if jacobian is None else np.isfinite(jacobian).all(axis=0)
    return followed(at, replace(start, slopes=slopes, made=made), iterations, fresh=np.asarray(~kept), rest=rest)


def followed(
    at: Case, start: Point, iterations: int, *, fresh: Bools | None = None, rest: float = 0.0
) -> Point:  # fmt: skip
    """Return the maximum of the posterior to which the derivatives of the start lead.

    Where a step falls short, those derivatives are made anew that it follows from; without such, it was too long.

    Parameters
    ----------
    fresh : ndarray of bool, shape (parameters + gains,), optional
        Which derivatives are made at the start; by default none is.
    rest : float
        Share of the squares of what derivatives contribute to a step; those that make no more are not made anew [1].
    """
    data, off, made = at.data, at.off, start.made
    here, own, expected, slopes = start.positions, start.gains, start.expected, start.slopes
    value, sd = _flat(data, expected, own, off)
    score = _score(value, sd, here, own)
    fresh, radius = np.zeros(slopes.shape[1], dtype=bool) if fresh is None else fresh, _RADIUS
    for _ in range(iterations):
        position = np.concatenate([here, own])
        step = _step(slopes, value, position, radius)
        length = float(np.linalg.norm(step))
        promised = _promise(slopes, value, position, step)
        if length < _SHORTEST or promised < _SMALL_GAIN:
            break
        there, other = (position + step)[: here.size], (position + step)[here.size :]
        reached = at.expected(there)
        gained = _BAD
        if reached is not None:
            after, wider = _flat(data, reached, other, off)
            gained = _score(after, wider, there, other) - score
            change = stacked(after * wider / sd - value, np.log(wider / sd))
            slopes = slopes + np.outer(change - slopes @ step, step) / length**2
        if reached is not None and gained > 0:
            slopes = _in_units(slopes, sd, wider)
            here, own, expected, value, sd, score = there, other, reached, after, wider, score + gained
            fresh = np.zeros_like(fresh)
        stale = _at_fault(slopes, value, step, fresh, rest=rest) if gained <= 0 else np.zeros_like(fresh)
        if gained >= _FALLEN_SHORT * promised:
            radius = min(max(radius, 2 * length), 4 * _RADIUS)
        elif stale.any():
            slopes = slopes_at(at, Point(here, own, expected), kept=np.where(stale, np.nan, slopes))
            fresh = fresh | stale
            made = position if fresh.all() else made
        else:
            radius = max(0.4 * length, _SHORTEST)
    return Point(here, own, tuple(expected), slopes, value, sd, score, made)


def _at_fault(slopes: Floats, value: Floats, step: Floats, fresh: Bools, *, rest: float) -> Bools:
    """Return the derivatives that are not fresh and make all but ``rest`` of the change that a step promises.

    Shape (parameters + gains,); none where those that are not fresh make less than ``rest``.
    """
    share = step**2 * np.einsum("f,fk,fk->k", row_weights(value), slopes, slopes)
    share = np.where(fresh, 0.0, share) / max(float(share.sum()), _NOTHING)
    order = np.argsort(-share)
    before = np.cumsum(share[order]) - share[order]
    chosen = np.zeros_like(fresh)
    chosen[order] = (before < (1 - rest) * share.sum()) | (rest == 0)
    return chosen & ~fresh if share.sum() > rest else np.zeros_like(fresh)


def resized(at: Case, found: Point, off: Discrepancy) -> Point:
    """Return a point with its derivatives in units of the standard deviations at other sizes of the discrepancy.

    Residuals of lines and bands hardly depend on the sizes, only their standard deviations do. Those of levels are made
    independent by a covariance that has the sizes in it; a step that falls short for it has its derivatives made anew.
    """
    before, after = (_flat(at.data, found.expected, found.gains, sizes)[1] for sizes in (at.off, off))
    return replace(found, slopes=_in_units(found.slopes, before, after))


def _in_units(slopes: Floats, before: Floats, after: Floats) -> Floats:
    """Return derivatives in units of other standard deviations; those of their logarithms have none."""
    return np.asarray(slopes * np.concatenate([before / after, np.ones(before.size)])[:, None])


def is_made_near(found: Point, knobs: Sequence[Knob]) -> bool:
    """Return whether the derivatives of a point were all made so near to it that they are right there.

    Features are smooth functions of the logarithms of the numbers of a model: no number may have changed by more than
    ``_FAR``. A number that is added, not a factor, and a gain may have moved by a standard deviation of their priors.
    """
    if found.made is None:
        return False
    moved = np.abs(np.concatenate([found.positions, found.gains]) - found.made)
    most = np.ones(moved.size)
    most[: len(knobs)] = [_FAR / knob.spread if knob.factor else 1.0 for knob in knobs]
    return bool((moved <= most).all())


def slopes_at(at: Case, point: Point, *, kept: Floats | None = None) -> Floats:
    """Return the derivatives at a point, residuals in units of their standard deviations there; see ``slopes``.

    Columns of ``kept`` that are finite are taken from it.
    """
    here, gains, expected = point.positions, point.gains, point.expected
    base = all_residuals(at.data, expected, gains, at.off)
    value, sd = _joined(base)
    slopes = np.full((2 * value.size, here.size + gains.size), np.nan) if kept is None else kept.copy()

    def moved(column: int) -> tuple[Floats, Floats]:
        """Return the residuals with one number moved, and their standard deviations."""
        position = np.concatenate([here, gains])
        position[column] += _STEP
        if column < here.size:
            there = at.expected(position[: here.size])
            return _joined(all_residuals(at.data, there or expected, gains, at.off))
        own = zip(at.data.seen, at.data.shapes, expected, base, strict=True)
        louder, gain = position[here.size :], column - here.size
        return _joined([residuals_with_moved_gain(*each, gains=louder, off=at.off, moved=gain) for each in own])

    columns = np.flatnonzero(~np.isfinite(slopes).all(axis=0)).tolist()
    many = sum(column < here.size for column in columns) >= _MANY
    values = parallel_map(moved, columns) if many else [moved(column) for column in columns]
    for column, (after, wider) in zip(columns, values, strict=True):
        slopes[:, column] = stacked((after - value) / sd, np.log(wider / sd)) / _STEP
    return slopes


def _score(value: Floats, sd: Floats, positions: Floats, gains: Floats) -> float:
    score = log_density_of(value, sd) - 0.5 * float(positions @ positions + gains @ gains)
    return score if np.isfinite(score) else _BAD


def _joined(found: Sequence[Residuals]) -> tuple[Floats, Floats]:
    return np.concatenate([each.value for each in found]), np.concatenate([each.sd for each in found])


def _flat(data: Data, expected: Sequence[ExpectedRun], gains: Floats, off: Discrepancy) -> tuple[Floats, Floats]:
    """Return the standardised residuals and their standard deviations."""
    value, sd = _joined(all_residuals(data, expected, gains, off))
    return value / sd, sd


def _step(slopes: Floats, value: Floats, position: Floats, radius: float) -> Floats:
    """Return the step to the maximum of the local model, no longer than the radius (Levenberg's parameter)."""
    hessian, gradient = hessian_of(slopes, value), gradient_of(slopes, value) + position
    damping = 0.0
    for _ in range(40):
        step = -np.linalg.solve(hessian + damping * np.eye(position.size), gradient)
        if np.linalg.norm(step) <= radius:
            break
        damping = max(2.5 * damping, 0.1)
    return np.asarray(step)


def _promise(slopes: Floats, value: Floats, position: Floats, step: Floats) -> float:
    """Return the gain that the local model promises for a step [nats]."""
    gradient = gradient_of(slopes, value) + position
    return float(-(gradient @ step) - 0.5 * step @ hessian_of(slopes, value) @ step)
