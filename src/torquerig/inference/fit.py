"""Maximum of the posterior of a model's parameters, and the evidence by Laplace's approximation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.climb import Case, Point, climbed, followed, is_made_near, resized
from torquerig.inference.data import Data, all_residuals
from torquerig.inference.discrepancy import estimated, is_near, log_prior
from torquerig.inference.knobs import Knob, turned
from torquerig.inference.likelihood import Discrepancy
from torquerig.inference.load_spectrum import with_gains
from torquerig.inference.prediction.expected_run import ExpectedRun
from torquerig.inference.slopes import hessian_of
from torquerig.rig.assembly import Rig

__all__ = ["Data", "Fit", "all_residuals", "finished", "fitted", "sketch_error", "sketched"]

Floats = NDArray[np.float64]

_ITERATIONS = 25
_ESTIMATES = 2  # of the sizes of the discrepancy, each followed by a climb
_REST = 0.1  # [1] of a step of a sketch: of derivatives that make less a wrong one is no fault
_SKETCHED = 5.0  # [nats] by which the odds of a sketched fit may be off: of six none was by more than 1
_SKETCHED_SHARE = 0.1  # [1] the same of what it gains: ripples of 754 and 769 nats were off by 39 and by 15
_FINISHES = 2  # at most: each makes all derivatives anew


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
    jacobian : ndarray, shape (2 features, knobs + triangles)
        Derivatives of the residuals and of their standard deviations; see ``slopes``.
    value : ndarray, shape (features,)
        Standardised residuals.
    sd : ndarray, shape (features,)
        Their standard deviations, in the units of the residuals.
    log_evidence : float
        [nats], without the constants that all models of the same data share.
    is_finished : bool
        Whether the derivatives were made near the maximum.
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
    is_finished: bool = True

    @property
    def fitted_rig(self) -> Rig:
        """The rig with its parameters at their estimates."""
        return turned(self.rig, self.knobs, self.positions)

    def covariance(self) -> Floats:
        """Return the posterior covariance of positions and gains."""
        return np.asarray(np.linalg.inv(hessian_of(self.jacobian, self.value)))


def fitted(
    rig: Rig, knobs: Sequence[Knob], data: Data, *, start: Floats | None = None, gains: Floats | None = None,
    off: Discrepancy | None = None, jacobian: Floats | None = None, nominal: Rig | None = None,
) -> Fit:  # fmt: skip
    """Return the maximum of the posterior that the start leads to; parameters as of ``sketched``.

    Log-evidence: ``log p(D, x^) - 1/2 log det H``, H the Hessian of the posterior in units of the prior (Laplace;
    MacKay 2003, Information Theory, Inference, and Learning Algorithms, 28).
    """
    return finished(
        sketched(rig, knobs, data, start=start, gains=gains, off=off, jacobian=jacobian, nominal=nominal, rest=0.0),
        data,
    )


def sketched(
    rig: Rig, knobs: Sequence[Knob], data: Data, *, start: Floats | None = None, gains: Floats | None = None,
    off: Discrepancy | None = None, jacobian: Floats | None = None, nominal: Rig | None = None,
    iterations: int = _ITERATIONS, rest: float = _REST,
) -> Fit:  # fmt: skip
    """Return a fit that is near the maximum of the posterior, by derivatives that are right where it began.

    Gauss-Newton steps within a trust region on reweighted residuals (Holland & Welsch 1977, Commun. Statist. A6). The
    derivatives are difference quotients at the start; Broyden's rank-one update (1965, Math. Comp. 19) follows them
    until a step falls short, when those that make most of the step are made anew. Most proposals of a search lose by
    far, and need no more.

    Parameters
    ----------
    off : Discrepancy, optional
        Where the estimate of its sizes begins.
    jacobian : ndarray, shape (2 features, knobs + gains), optional
        Derivatives of an earlier fit near the start; a column of NaN is made anew.
    nominal : Rig, optional
        The scenario's, where ``rig`` has additions.
    rest : float
        Share of a step whose derivatives are not made anew [1]; see ``followed``.
    """
    start = np.zeros(len(knobs)) if start is None else start.copy()
    gains = np.zeros(data.shapes[0].count) if gains is None else gains.copy()
    at = Case(rig, tuple(knobs), data, off or Discrepancy())
    expected = at.expected(start)
    if expected is None:
        raise ValueError("the model cannot be evaluated at its start")
    found = climbed(at, Point(start, gains, expected), iterations, jacobian=jacobian, rest=rest)
    return _settled(at, found, nominal or rig, iterations, rest=rest)


def sketch_error(gain: float) -> float:
    """Return by how much the odds of a sketched fit may be off that gains so much [nats]."""
    return max(_SKETCHED, _SKETCHED_SHARE * gain)


def finished(fit: Fit, data: Data) -> Fit:
    """Return the maximum of the posterior next to a fit, with derivatives that were made near it."""
    for _ in range(_FINISHES):
        if fit.is_finished:
            break
        at = Case(fit.rig, fit.knobs, data, fit.off)
        found = climbed(at, Point(fit.positions, fit.gains, fit.expected), _ITERATIONS)
        fit = _settled(at, found, fit.nominal, _ITERATIONS, rest=0.0)
    return fit


def _settled(at: Case, found: Point, nominal: Rig, iterations: int, *, rest: float) -> Fit:
    """Return the fit with the sizes of the discrepancy estimated, each estimate followed by a climb."""
    data = at.data
    for _ in range(_ESTIMATES):
        models = [with_gains(model, shape, found.gains)
                  for model, shape in zip(found.expected, data.shapes, strict=True)]  # fmt: skip
        sizes = estimated(data.seen, models, at.off)
        if is_near(sizes, at.off):
            break
        found = resized(at, found, sizes)
        at = replace(at, off=sizes)
        found = followed(at, found, iterations, rest=rest)
    _, logdet = np.linalg.slogdet(hessian_of(found.slopes, found.value))
    return Fit(
        nominal, at.rig, at.knobs, found.positions, found.gains, at.off, tuple(found.expected), found.score,
        found.slopes, found.value, found.sd, log_evidence=found.score + log_prior(at.off) - 0.5 * float(logdet),
        is_finished=is_made_near(found, at.knobs),
    )  # fmt: skip
