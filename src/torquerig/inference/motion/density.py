"""The density of coloured residuals, smooth over frequency and estimated with the model, and their likelihood.

Whittle's likelihood (Whittle 1953, J. R. Stat. Soc. B 15): each coefficient R of a frame is independent with the
variance S(f). In place of the normal distribution stands Student's with 8 degrees of freedom and the scale sqrt(S), so
that one odd frame in a hundred does not decide:

    ln p = - sum [ 1/2 ln S + 9/2 ln(1 + R^2 / 8 S) ]

``ln S`` is piecewise linear over octaves, with a free gain for each run. Not true for residuals whose density has
lines; those are searched as effects of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.motion.imposed_run import ImposedRun

Floats = NDArray[np.float64]

DEGREES_OF_FREEDOM = 8.0  # as of the features in torquerig.inference.likelihood
_PER_OCTAVE = 1.5  # [nats] standard deviation of the change of ln S over an octave, 6 dB: the slope of common noise
_OF_A_RUN = 1.0  # [nats] standard deviation of a run's gain
_INFORMATION = DEGREES_OF_FREEDOM / (2 * (DEGREES_OF_FREEDOM + 3))  # of a coefficient on ln S
_STEPS = 30
_LEAST = 1e-5  # of the rms effort: residuals of a noiseless simulation


@dataclass(frozen=True, eq=False)
class Shape:
    """Which nodes of ``ln S`` each coefficient has, for stacked runs.

    Parameters
    ----------
    basis : ndarray, shape (rows, nodes + runs)
        Hat functions over octaves and one column a run, one row for each bin of each run.
    precision : ndarray, shape (nodes + runs, nodes + runs)
        Of the prior.
    """

    basis: Floats
    precision: Floats


def shape_of(runs: Sequence[ImposedRun]) -> Shape:
    """Return the nodes of the density of some runs: one an octave, from their lowest to their highest frequency."""
    octaves = [np.log2(run.frequencies) for run in runs]
    low, high = min(each.min() for each in octaves), max(each.max() for each in octaves)
    nodes = np.linspace(low, high, max(2, round(high - low) + 1))
    hats = [np.array([np.interp(each, nodes, row) for row in np.eye(nodes.size)]).T for each in octaves]
    basis = np.zeros((sum(each.size for each in octaves), nodes.size + len(runs)))
    precision = np.zeros((basis.shape[1], basis.shape[1]))
    change = np.diff(np.eye(nodes.size), axis=0)
    precision[: nodes.size, : nodes.size] = change.T @ change / _PER_OCTAVE**2 + 1e-6 * np.eye(nodes.size)
    start = 0
    for number, each in enumerate(hats):
        basis[start : start + len(each), : nodes.size] = each
        basis[start : start + len(each), nodes.size + number] = 1.0
        precision[nodes.size + number, nodes.size + number] = 1 / _OF_A_RUN**2
        start += len(each)
    return Shape(basis, precision)


def fitted_density(
    shape: Shape, squares: Sequence[Floats], start: Floats, *, least: float
) -> Floats:  # fmt: skip
    """Return the values of the nodes at their posterior maximum, by Fisher scoring.

    Parameters
    ----------
    squares : sequence of ndarray, each of shape (frames, bins)
        Squared residuals of each run; a run may have no frame.
    start : ndarray, shape (nodes + runs,)
    least : float
        The density is not below the square of ``_LEAST`` times this [N m] or [N].
    """
    at = start.copy()
    count = np.concatenate([np.full(each.shape[1], float(len(each))) for each in squares])
    information = shape.basis.T @ (shape.basis * (_INFORMATION * count)[:, None]) + shape.precision
    for _ in range(_STEPS):
        density = np.split(np.exp(shape.basis @ at), np.cumsum([each.shape[1] for each in squares])[:-1])
        floor = (_LEAST * least) ** 2
        score = np.concatenate([
            0.5 * ((DEGREES_OF_FREEDOM + 1) * each / (DEGREES_OF_FREEDOM * (s + floor) + each) - 1).sum(axis=0)
            for each, s in zip(squares, density, strict=True)
        ])  # fmt: skip
        step = np.linalg.solve(information, shape.basis.T @ score - shape.precision @ at)
        step *= min(1.0, 2.0 / max(float(np.abs(step).max()), 1e-9))
        at = at + step
        if float(np.abs(step).max()) < 1e-3:
            break
    return at


def densities(shape: Shape, at: Floats, runs: Sequence[ImposedRun], *, least: float) -> list[Floats]:
    """Return S of each run, each of shape (bins,)."""
    sizes = [run.frequencies.size for run in runs]
    return [each + (_LEAST * least) ** 2 for each in np.split(np.exp(shape.basis @ at), np.cumsum(sizes)[:-1])]


def log_density(residual: Floats, density: Floats) -> float:
    """Return the logarithm of the likelihood, without its constant [nats]; arrays broadcast."""
    spread = np.broadcast_to(density, residual.shape)
    tails = np.log1p(residual**2 / (DEGREES_OF_FREEDOM * spread))
    return float(-0.5 * np.log(spread).sum() - 0.5 * (DEGREES_OF_FREEDOM + 1) * tails.sum())


def weights(residual: Floats, density: Floats) -> Floats:
    """Return the weight of each coefficient in a least-squares step, in the form of 1 / variance."""
    return (DEGREES_OF_FREEDOM + 1) / (DEGREES_OF_FREEDOM * density + residual**2)
