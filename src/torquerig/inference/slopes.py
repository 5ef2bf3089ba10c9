"""Derivatives of the residuals of a model, and of their standard deviations, by its parameters.

A standardised residual ``z = r / s`` of Student's distribution with nu degrees of freedom has the log-density
``-(nu + 1) / 2 ln(1 + z^2 / nu) - ln s``. With ``J`` the derivatives of r over s, ``Q`` those of ``ln s`` and the
weight ``w = (nu + 1) / (nu + z^2)``, minus the log-density has the gradient ``J'(w z) + Q'(1 - w z^2)`` and about the
Hessian ``J' w J + 2 nu / (nu + 3) Q'Q``: of J the reweighted, of Q the expected one (Fisher scoring; Lange, Little &
Taylor 1989, J. Am. Stat. Assoc. 84). ``J`` stands above ``sqrt(2 nu / (nu + 3)) Q``, shape (2 features, parameters).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.likelihood import DEGREES_OF_FREEDOM, weights

Floats = NDArray[np.float64]

_INFORMATION = 2 * DEGREES_OF_FREEDOM / (DEGREES_OF_FREEDOM + 3)  # [1] of a value about the logarithm of its scale


def stacked(value: Floats, log_sd: Floats) -> Floats:
    """Return changes of standardised residuals, and of the logarithms of their standard deviations, as one column."""
    return np.concatenate([value, np.sqrt(_INFORMATION) * log_sd])


def row_weights(value: Floats) -> Floats:
    """Return the weight of each row of the derivatives, shape (2 features,), at standardised residuals."""
    return np.concatenate([weights(value), np.ones(value.size)])


def hessian_of(slopes: Floats, value: Floats) -> Floats:
    """Return the Hessian of minus the log-posterior in units of the prior, at standardised residuals."""
    return np.asarray(slopes.T @ (slopes * row_weights(value)[:, None]) + np.eye(slopes.shape[1]))


def gradient_of(slopes: Floats, value: Floats) -> Floats:
    """Return the gradient of minus the log-likelihood, at standardised residuals."""
    weighted = weights(value) * value
    return np.asarray(slopes.T @ np.concatenate([weighted, (1 - weighted * value) / np.sqrt(_INFORMATION)]))


def after_step(slopes: Floats, value: Floats, sd: Floats, step: Floats) -> tuple[Floats, Floats]:
    """Return the standardised residuals and their standard deviations to which derivatives lead."""
    change = slopes @ step
    wider = np.exp(change[value.size :] / np.sqrt(_INFORMATION))
    return np.asarray((value + change[: value.size]) / wider), np.asarray(sd * wider)
