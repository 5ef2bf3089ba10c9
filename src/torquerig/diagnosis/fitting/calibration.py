"""The nominal model with its uncertain numbers fitted: what must come before anything is called missing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.expecting.correction import Correction, corrected
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.least_squares import minimum, weights
from torquerig.diagnosis.fitting.misfit import BEND, Misfit, misfit, misfit_sum
from torquerig.diagnosis.looking.features import Features
from torquerig.inference.knobs import Knob, turned
from torquerig.rig.assembly import Rig

MOST_DERIVATIVES = 6  # sets of them
LIMIT = 7.0  # a knob goes no further than this many of its spreads


@dataclass(frozen=True)
class Calibrated:
    """A model fitted to features.

    Parameters
    ----------
    rig : Rig
        With every knob at its fitted position.
    knobs : tuple of Knob
    positions : ndarray, shape (knobs,)
        In spreads from the value that the model started with.
    covariance : ndarray, shape (knobs, knobs)
        Of the positions.
    misfits : tuple of Misfit
        One per run.
    cost : float
        Sum of squares of robust residuals and of positions.
    corrections : tuple of Correction
        One per run where an effect is beyond the twin; else empty.
    jacobian : ndarray, shape (features, knobs)
        Of the residuals to the positions.
    """

    rig: Rig
    knobs: tuple[Knob, ...]
    positions: NDArray[np.float64]
    covariance: NDArray[np.float64]
    misfits: tuple[Misfit, ...]
    cost: float
    corrections: tuple[Correction, ...] = ()
    jacobian: NDArray[np.float64] | None = None


def misfits_of(
    rig: Rig, seen: Sequence[Features], corrections: Sequence[Correction] | None = None
) -> tuple[Misfit, ...]:
    """Return the misfit of every run against the linear twin of ``rig``, corrected for what no twin can hold."""
    models = [expected(rig, features) for features in seen]
    if corrections is not None:
        models = [corrected(model, correction) for model, correction in zip(models, corrections, strict=True)]
    return tuple(misfit(features, model) for features, model in zip(seen, models, strict=True))


def calibrated(
    rig: Rig, seen: Sequence[Features], knobs: Sequence[Knob], *, start: NDArray[np.float64] | None = None,
    derivatives: int = MOST_DERIVATIVES, corrections: Sequence[Correction] | None = None,
    jacobian: NDArray[np.float64] | None = None, near: bool = True,
) -> Calibrated:  # fmt: skip
    """Return the rig whose knobs minimise the misfit plus the squares of their positions (a log-normal prior).

    ``jacobian`` and ``near`` as for ``minimum``.
    """
    from threadpoolctl import threadpool_limits

    def residuals(positions: NDArray[np.float64]) -> NDArray[np.float64]:
        each = misfits_of(turned(rig, knobs, positions), seen, corrections)
        return np.concatenate([one.paid() for one in each])

    first = np.zeros(len(knobs)) if start is None else start
    with threadpool_limits(limits=1, user_api="blas"):  # matrices this small only make more threads spin
        found = minimum(residuals, first, limit=LIMIT, derivatives=derivatives, bend=BEND, jacobian=jacobian, near=near)
        fitted = turned(rig, knobs, found.positions)
        misfits = misfits_of(fitted, seen, corrections)
        counted = weights(np.concatenate([one.paid() for one in misfits]), BEND)[:, None] * found.jacobian
        covariance = np.asarray(np.linalg.inv(found.jacobian.T @ counted + np.eye(len(knobs))), dtype=np.float64)
    cost = misfit_sum(misfits) + float(found.positions @ found.positions)
    held = () if corrections is None else tuple(corrections)
    return Calibrated(fitted, tuple(knobs), found.positions, covariance, misfits, cost, held, found.jacobian)
