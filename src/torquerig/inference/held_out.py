"""Residuals and likelihood of data that no fit has seen: blocks of fitted runs, or whole runs.

A run that was not fitted at all has a strength of its load that nothing determined. It enters the covariance: with the
derivatives A of the standardised residuals by such open gains, each in standard deviations, ``C = I + A A'``.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.fit import Data, Fit, all_residuals
from torquerig.inference.likelihood import Residuals, log_density, residuals
from torquerig.inference.load_spectrum import with_gains
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_STEP = 0.05  # [standard deviations] of a difference quotient


def held_residuals(fit: Fit, held: Data) -> list[Residuals]:
    """Return the residuals of held-out data under a fitted model, made independent where a gain is open."""
    return [each for each, _ in _of_runs(fit, held)]


def residuals_of_means(means: Fit, fit: Fit, held: Data, rig: Rig) -> list[Residuals]:
    """Return the residuals of the means of one fit with the load and the discrepancy of another.

    ``rig`` is that of ``fit`` without its additions: a wave of unknown phase is in the covariance of mean torques, and
    would count as an error of the model there.
    """
    expected = [expected_run(fit.fitted_rig, seen) for seen in held.seen]
    slopes = _open_slopes(fit, held, expected, all_residuals(held, expected, fit.gains, fit.off))
    found = list[Residuals]()
    for seen, shape, slope in zip(held.seen, held.shapes, slopes, strict=True):
        mean = with_gains(expected_run(means.fitted_rig, seen), shape, means.gains)
        mixed = replace(
            with_gains(expected_run(rig, seen), shape, fit.gains), line_power=mean.line_power, density=mean.density,
            level=mean.level, block_gain=mean.block_gain,
        )  # fmt: skip
        found.append(independent(residuals(seen, mixed, fit.off), slope)[0])
    return found


def held_out_density(fit: Fit, held: Data) -> float:
    """Return the log-likelihood of held-out data under a fitted model [nats]."""
    return sum(log_density(each) - 0.5 * logdet for each, logdet in _of_runs(fit, held))


def _of_runs(fit: Fit, held: Data) -> list[tuple[Residuals, float]]:
    """Return the residuals of each run and the logarithm of the determinant of ``C``."""
    rig = fit.fitted_rig
    expected = [expected_run(rig, seen) for seen in held.seen]
    found = all_residuals(held, expected, fit.gains, fit.off)
    slopes = _open_slopes(fit, held, expected, found)
    return [independent(each, slope) for each, slope in zip(found, slopes, strict=True)]


def _open_slopes(fit: Fit, held: Data, expected: list[ExpectedRun], found: list[Residuals]) -> list[Floats]:
    """Return the derivatives of the standardised residuals of each run by the gains that no fitted data determine."""
    shown = fit.jacobian[:, len(fit.knobs) :].any(axis=0)
    moves = [gain for gain in np.flatnonzero(~shown).tolist() if any(each.acts(gain) for each in held.shapes)]
    columns = list[list[Floats]]()
    for gain in moves:
        gains = fit.gains.copy()
        gains[gain] += _STEP
        moved = all_residuals(held, expected, gains, fit.off)
        columns.append([(one.value - each.value) / (_STEP * each.sd) for one, each in zip(moved, found, strict=True)])
    return [np.stack([column[row] for column in columns], axis=1) if moves else np.zeros((each.value.size, 0))
            for row, each in enumerate(found)]  # fmt: skip


def independent(each: Residuals, slope: Floats) -> tuple[Residuals, float]:
    """Return residuals times ``C^-1/2``, and the logarithm of the determinant of C."""
    if not slope.any():
        return each, 0.0
    along, size, _ = np.linalg.svd(slope, full_matrices=False)
    value = each.standardised
    value = value + along @ ((1 / np.sqrt(1 + size**2) - 1) * (along.T @ value))
    return replace(each, value=value * each.sd), float(np.log1p(size**2).sum())
