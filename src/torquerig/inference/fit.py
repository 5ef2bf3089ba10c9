"""Maximum of the posterior of a model's parameters, and the evidence by Laplace's approximation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.discrepancy import estimated, is_near, log_prior
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.knobs import Knob, turned
from torquerig.inference.likelihood import Discrepancy, Residuals, log_density, residuals, weights
from torquerig.inference.load_spectrum import GainShapes, gain_shapes, with_gains
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.moved_gain import values_with_moved_gain
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run
from torquerig.parallel import parallel_map
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_STEP = 0.05  # [standard deviations] of a difference quotient
_RADIUS = 4.0  # [standard deviations] longest step at first
_SHORTEST = 1e-3  # [standard deviations] a shorter step ends the search
_SMALL_GAIN = 0.02  # [nats] a smaller one ends the search
_ITERATIONS = 25
_FALLEN_SHORT = 0.25  # share of the promised gain below which a step was too long
_ESTIMATES = 2  # of the sizes of the discrepancy, each followed by a fit
_MANY = 12  # parameters whose derivatives take longer than a second process to start
_BAD = -1e12  # [nats] of a rig that cannot be


@dataclass(frozen=True, eq=False)
class Fit:
    """A model at the maximum of its posterior.

    Parameters
    ----------
    nominal : Rig
        Of the scenario.
    rig : Rig
        With additions, every parameter at its prior median.
    knobs : tuple of Knob
        The parameters; their prior is a standard normal distribution of the position.
    positions : ndarray, shape (knobs,)
    gains : ndarray, shape (triangles,)
        Of the load's spectrum, in standard deviations.
    off : Discrepancy
        Estimated with the parameters.
    expected : tuple of ExpectedRun
        By run, gains not applied.
    log_posterior : float
        Log-likelihood plus log-prior of positions and gains, each without constants [nats].
    jacobian : ndarray, shape (features, knobs + triangles)
        Of the standardised residuals.
    value : ndarray, shape (features,)
        Standardised residuals.
    sd : ndarray, shape (features,)
        Their standard deviations, in the units of the residuals.
    log_evidence : float
        [nats], without the constants that all models of the same data share.
    """

    nominal: Rig
    rig: Rig
    knobs: tuple[Knob, ...]
    positions: Floats
    gains: Floats
    off: Discrepancy
    expected: tuple[ExpectedRun, ...]
    log_posterior: float
    jacobian: Floats = field(repr=False)
    value: Floats = field(repr=False)
    sd: Floats = field(repr=False)
    log_evidence: float = -np.inf

    @property
    def fitted_rig(self) -> Rig:
        """The rig with its parameters at their estimates."""
        return turned(self.rig, self.knobs, self.positions)

    def covariance(self) -> Floats:
        """Return the posterior covariance of positions and gains."""
        return np.asarray(np.linalg.inv(hessian_of(self.jacobian, self.value)))


@dataclass(frozen=True, eq=False)
class Data:
    """Features of all runs, with the triangles of the load's spectrum in the bands of each."""

    seen: tuple[RunFeatures, ...]
    shapes: tuple[GainShapes, ...]

    @staticmethod
    def of(seen: Sequence[RunFeatures], *, rows: Sequence[int] | None = None, runs: Sequence[MeasuredRun] = ()) -> Data:
        """Return the data of the features of all runs, or of those with the numbers ``rows`` among ``runs``."""
        numbers, all_runs = range(len(seen)) if rows is None else rows, runs or [each.run for each in seen]
        shapes = [gain_shapes(each, run=row, runs=all_runs) for row, each in zip(numbers, seen, strict=True)]
        return Data(tuple(seen), tuple(shapes))


def all_residuals(data: Data, expected: Sequence[ExpectedRun], gains: Floats, off: Discrepancy) -> list[Residuals]:
    """Return the residuals of each run, the gains of the load's spectrum applied."""
    return [
        residuals(seen, with_gains(model, shape, gains), off)
        for seen, model, shape in zip(data.seen, expected, data.shapes, strict=True)
    ]


def fitted(
    rig: Rig, knobs: Sequence[Knob], data: Data, *, start: Floats | None = None, gains: Floats | None = None,
    off: Discrepancy | None = None, jacobian: Floats | None = None, nominal: Rig | None = None,
    iterations: int = _ITERATIONS,
) -> Fit:  # fmt: skip
    """Return the maximum of the posterior that the start leads to.

    Gauss-Newton steps within a trust region on reweighted residuals (Holland & Welsch 1977, Commun. Statist. A6). The
    derivatives are difference quotients at the start; Broyden's rank-one update (1965, Math. Comp. 19) follows them
    until a step falls short, when they are made anew. Log-evidence: ``log p(D, x^) - 1/2 log det H``, H the
    Gauss-Newton Hessian of the posterior in units of the prior (Laplace; MacKay 2003, Information Theory, Inference,
    and Learning Algorithms, 28).

    Parameters
    ----------
    off : Discrepancy, optional
        Where the estimate of its sizes begins.
    jacobian : ndarray, shape (features, knobs + gains), optional
        Derivatives of an earlier fit near the start; a column of NaN is made anew.
    nominal : Rig, optional
        The scenario's, where ``rig`` has additions.
    """
    start = np.zeros(len(knobs)) if start is None else start.copy()
    gains = np.zeros(data.shapes[0].count) if gains is None else gains.copy()
    at = _Case(rig, tuple(knobs), data, off or Discrepancy())
    expected = at.expected(start)
    if expected is None:
        raise ValueError("the model cannot be evaluated at its start")
    found = _climbed(at, _Point(start, gains, expected), jacobian, iterations)
    for _ in range(_ESTIMATES):
        models = [with_gains(model, shape, found.gains)
                  for model, shape in zip(found.expected, data.shapes, strict=True)]  # fmt: skip
        sizes = estimated(data.seen, models, at.off)
        if is_near(sizes, at.off):
            break
        at = replace(at, off=sizes)
        found = _climbed(at, _Point(found.positions, found.gains, found.expected), None, iterations)
    sd = np.concatenate([each.sd for each in all_residuals(data, found.expected, found.gains, at.off)])
    _, logdet = np.linalg.slogdet(hessian_of(found.slopes, found.value))
    return Fit(
        nominal or rig, rig, tuple(knobs), found.positions, found.gains, at.off, tuple(found.expected), found.score,
        found.slopes, found.value, sd, log_evidence=found.score + log_prior(at.off) - 0.5 * float(logdet),
    )  # fmt: skip


def _score(data: Data, expected: Sequence[ExpectedRun], positions: Floats, gains: Floats, off: Discrepancy) -> float:
    total = sum(log_density(each) for each in all_residuals(data, expected, gains, off))
    score = total - 0.5 * float(positions @ positions + gains @ gains)
    return score if np.isfinite(score) else _BAD


def _flat(data: Data, expected: Sequence[ExpectedRun], gains: Floats, off: Discrepancy) -> Floats:
    return np.concatenate([each.standardised for each in all_residuals(data, expected, gains, off)])


@dataclass(frozen=True, eq=False)
class _Case:
    """What stays the same while a fit moves."""

    rig: Rig
    knobs: tuple[Knob, ...]
    data: Data
    off: Discrepancy
    made: dict[bytes, list[ExpectedRun] | None] = field(default_factory=dict)  # by positions, for the latest slopes

    def expected(self, positions: Floats) -> list[ExpectedRun] | None:
        """Return what the model expects of each run; None where such a rig cannot be."""
        try:
            at = turned(self.rig, self.knobs, positions)
            return [expected_run(at, seen) for seen in self.data.seen]
        except (TorquerigError, ValueError, OverflowError, np.linalg.LinAlgError):
            return None


@dataclass(frozen=True, eq=False)
class _Point:
    """Where a fit is: parameters, gains, what the model expects there, and derivatives and score when it is reached."""

    positions: Floats
    gains: Floats
    expected: Sequence[ExpectedRun]
    slopes: Floats = field(default_factory=lambda: np.zeros((0, 0)))
    value: Floats = field(default_factory=lambda: np.zeros(0))
    score: float = 0.0


def _climbed(at: _Case, start: _Point, jacobian: Floats | None, iterations: int) -> _Point:
    """Return the maximum of the posterior that a start leads to, the discrepancy's sizes held."""
    data, off = at.data, at.off
    here, own, expected = start.positions, start.gains, start.expected
    score, value = _score(data, expected, here, own, off), _flat(data, expected, own, off)
    slopes = _slopes(at, here, own, expected, kept=jacobian)
    radius, fresh = _RADIUS, jacobian is None
    for _ in range(iterations):
        position = np.concatenate([here, own])
        step = _step(slopes, value, position, radius)
        length = float(np.linalg.norm(step))
        promised = _promise(slopes, value, position, step)
        if length < _SHORTEST or promised < _SMALL_GAIN:
            break
        there, other = (position + step)[: here.size], (position + step)[here.size :]
        reached = at.expected(there)
        gained = _BAD if reached is None else _score(data, reached, there, other, off) - score
        if reached is not None:
            after = _flat(data, reached, other, off)
            slopes = slopes + np.outer(after - value - slopes @ step, step) / length**2
        if reached is not None and gained > 0:
            here, own, expected, value, score = there, other, reached, after, score + gained
        if gained >= _FALLEN_SHORT * promised:
            radius = min(max(radius, 2 * length), 4 * _RADIUS)
        elif fresh or gained > 0:
            radius, fresh = max(0.4 * length, _SHORTEST), fresh and gained <= 0
        else:
            slopes, fresh = _slopes(at, here, own, expected), True
        if gained > 0:
            fresh = False
    return _Point(here, own, tuple(expected), slopes, value, score)


def _slopes(
    at: _Case, here: Floats, gains: Floats, expected: Sequence[ExpectedRun], *, kept: Floats | None = None
) -> Floats:
    """Return the derivatives of the residuals, in units of their standard deviations at ``here``.

    Columns of ``kept`` that are finite are taken from it.
    """
    base = all_residuals(at.data, expected, gains, at.off)
    value = np.concatenate([each.value for each in base])
    sd = np.concatenate([each.sd for each in base])
    slopes = np.full((value.size, here.size + gains.size), np.nan) if kept is None else kept.copy()
    made = dict[bytes, list[ExpectedRun] | None]()

    def moved(column: int) -> Floats:
        """Return the residuals with one number moved; what the model expects there is kept, but not of a child."""
        position = np.concatenate([here, gains])
        position[column] += _STEP
        if column >= here.size:
            own = zip(at.data.seen, at.data.shapes, expected, base, strict=True)
            louder, gain = position[here.size :], column - here.size
            return np.concatenate([values_with_moved_gain(*each, gains=louder, off=at.off, moved=gain) for each in own])
        key = position[: here.size].tobytes()
        there = made[key] = at.made[key] if key in at.made else at.expected(position[: here.size])
        return np.concatenate([each.value for each in all_residuals(at.data, there or expected, gains, at.off)])

    columns = np.flatnonzero(~np.isfinite(slopes).all(axis=0)).tolist()
    many = sum(column < here.size for column in columns) >= _MANY
    values = parallel_map(moved, columns) if many else [moved(column) for column in columns]
    for column, after in zip(columns, values, strict=True):
        slopes[:, column] = (after - value) / (sd * _STEP)
    at.made.clear()
    at.made.update(made)
    return slopes


def hessian_of(slopes: Floats, value: Floats) -> Floats:
    """Return the Gauss-Newton Hessian of minus the log-posterior in units of the prior, at standardised residuals."""
    weighted = slopes * weights(value)[:, None]
    return np.asarray(slopes.T @ weighted + np.eye(slopes.shape[1]))


def _step(slopes: Floats, value: Floats, position: Floats, radius: float) -> Floats:
    """Return the step to the maximum of the local model, no longer than the radius (Levenberg's parameter)."""
    hessian = hessian_of(slopes, value)
    gradient = slopes.T @ (weights(value) * value) + position
    damping = 0.0
    for _ in range(40):
        step = -np.linalg.solve(hessian + damping * np.eye(position.size), gradient)
        if np.linalg.norm(step) <= radius:
            break
        damping = max(2.5 * damping, 0.1)
    return np.asarray(step)


def _promise(slopes: Floats, value: Floats, position: Floats, step: Floats) -> float:
    """Return the gain that the local model promises for a step [nats]."""
    hessian = hessian_of(slopes, value)
    gradient = slopes.T @ (weights(value) * value) + position
    return float(-(gradient @ step) - 0.5 * step @ hessian @ step)
