"""Mean torques of all runs against a fitted model, and how much of their residuals a course explains."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import block_diag, solve_triangular

from torquerig.inference.context import Context
from torquerig.inference.fit import all_residuals
from torquerig.inference.likelihood import LEVEL, level_root, weights
from torquerig.inference.load_spectrum import with_gains
from torquerig.inference.slopes import hessian_of

Floats = NDArray[np.float64]

_SAME = 1e-9  # [1] of the square of a course: less is left where parameters of the model explain all of it


@dataclass(frozen=True, eq=False)
class MeanTorques:
    """Mean torques of all runs, one after the other.

    Parameters
    ----------
    low, high : ndarray, shape (levels,)
        Shares of the recording between which each is [1].
    speed : ndarray, shape (levels, POINTS)
        Of the motor at moments of each part [rad/s].
    swept : ndarray of bool, shape (levels,)
        Whether the run changes its speed.
    expected : ndarray, shape (levels,)
        [N m]
    sign : ndarray, shape (levels,)
        Of the torque per unit of the recorded channel.
    root : ndarray, shape (levels, levels)
        Lower triangular root of their covariance [N m].
    rest, weight : ndarray, shape (levels,)
        Standardised residuals and the weights by which least squares follow the likelihood.
    slopes : ndarray, shape (levels, parameters)
        Of the standardised residuals by the parameters of the model.
    hessian : ndarray, shape (parameters, parameters)
        Of all features.
    """

    low: Floats
    high: Floats
    speed: Floats
    swept: NDArray[np.bool_]
    expected: Floats
    sign: Floats
    root: Floats
    rest: Floats
    weight: Floats
    slopes: Floats
    hessian: Floats

    @staticmethod
    def of(context: Context) -> MeanTorques:
        """Return those of the fitted blocks."""
        fit, seen = context.fit, context.data.seen
        found = all_residuals(context.data, fit.expected, fit.gains, fit.off)
        rows = np.concatenate([each.kind for each in found]) == LEVEL
        models = [with_gains(*each, fit.gains) for each in zip(fit.expected, context.data.shapes, strict=True)]
        roots = [level_root(*each, fit.off) for each in zip(seen, models, strict=True)]
        shares = np.concatenate([each.parts / each.run.torque.size for each in seen])
        count = [each.level.size for each in seen]
        return MeanTorques(
            low=shares[:, 0], high=shares[:, 1], speed=np.concatenate([each.level_speed for each in seen]),
            swept=np.repeat([not each.run.is_steady for each in seen], count),
            expected=np.concatenate([each.level for each in models]),
            sign=np.repeat([np.sign(each.unit) for each in seen], count), root=block_diag(*roots),
            rest=fit.value[rows], weight=weights(fit.value)[rows], slopes=fit.jacobian[: rows.size][rows],
            hessian=hessian_of(fit.jacobian, fit.value),
        )  # fmt: skip

    def explained(self, courses: Floats) -> tuple[Floats, Floats]:
        """Return the gain of the log-posterior by each course [nats], and its size in units of the course.

        ``courses`` [N m] has the shape (levels, courses), the answers (courses,). Rao's score test at the maximum of
        the posterior: with the standardised course c, residuals r, weights W, slopes J and the Hessian H of the model,
        ``(c'W r)^2 / 2 / (c'W c - c'W J H^-1 J'W c)``; the parameters of the model follow the course.
        """
        if not self.rest.size:
            return np.zeros(courses.shape[1]), np.zeros(courses.shape[1])
        columns = solve_triangular(self.root, courses, lower=True)
        along = columns.T @ (self.weight * self.rest)
        shared = self.slopes.T @ (self.weight[:, None] * columns)
        square = np.einsum("l,lc->c", self.weight, np.square(columns))
        free = square - np.einsum("pc,pc->c", shared, np.linalg.solve(self.hessian, shared))
        shown = free > _SAME * square
        free = np.where(shown, free, 1.0)
        return np.where(shown, 0.5 * along**2 / free, 0.0), np.where(shown, along / free, 0.0)
