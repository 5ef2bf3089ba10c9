"""Whether a model fits as a whole, where no single place of it is significantly wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log10, sqrt

import numpy as np
from scipy.stats import chi2

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import misfits_of
from torquerig.diagnosis.fitting.misfit import Misfit, missed_alone, robust_squares
from torquerig.diagnosis.looking.features import Features
from torquerig.inference.answer.mismatch import Mismatch

_LARGEST = 1.1  # held-out misfit; of 130 blind rigs with nothing hidden, of four programs, the largest was 0.89
FAR = 1.5  # the same, beyond which something is missing, or what was found has missed the most of it
_ALONE = 1.0  # per feature, prices apart, where fits may see and where not: 110 clean rigs reach 0.72 and 1.06
_BY_CHANCE = (
    0.01  # of a place: 8 of 10 such rigs with something hidden stand below 4e-4, two clean ones at 0.08 and 0.15
)


def misfit_as_a_whole(
    case: Case, unseen: Sequence[Features], *, held_out: float, coarse: bool = False
) -> tuple[Mismatch, ...]:
    """Return the run, and the domain of it, whose residuals together are largest for their number.

    None where what no fit has seen is missed by no more than chance brings, or what was seen is, unless the former is
    missed by far: a run of bad luck in the last third of the recordings is no place in which a model is wrong.

    Parameters
    ----------
    case : Case
        With the finished model.
    unseen : sequence of Features
        Of the stretches that no fit has seen.
    held_out : float
        Misfit of them beside simulations [1].
    coarse : bool
        Whether the codes are coarse, of which a twin has the power and not what a signal within few of them becomes.
    """
    worst = max(_kinds(case), key=lambda mismatch: mismatch.excess_dB, default=None)
    badly = held_out > _LARGEST or (not coarse and missed_everywhere(case, unseen))
    told = worst is not None and (worst.p_value < _BY_CHANCE or held_out > FAR)
    return (worst,) if worst is not None and badly and told else ()


def missed_everywhere(case: Case, unseen: Sequence[Features], *, by: float = _ALONE) -> bool:
    """Whether the twin misses what was seen and what was not by more than features of a true model are missed.

    ``by`` is per feature, prices apart. Beyond the twin only simulations can tell: False.
    """
    if case.model.corrections:
        return False
    every = (case.model.misfits, misfits_of(case.model.rig, unseen))
    return all(missed_alone(each) > by * sum(misfit.seen for misfit in each) for each in every)


def _kinds(case: Case) -> Iterator[Mismatch]:
    for features, misfit in zip(case.seen, case.model.misfits, strict=True):
        if misfit.bands.any():
            low, high = float(features.band[0]), float(features.band[-1])
            yield _mismatch(
                features, misfit.bands, domain="frequency", axis="Hz", at=sqrt(low * high), width=high - low
            )
        speeds = np.abs(features.observed.speed) * 30 / np.pi
        for residuals in _of_the_speed(misfit):
            yield _mismatch(
                features, residuals, domain="speed", axis="rpm", at=float(speeds.mean()), width=float(np.ptp(speeds))
            )


def _of_the_speed(misfit: Misfit) -> Iterator[np.ndarray]:
    yield from (each for each in (misfit.lines.ravel(), misfit.level, misfit.turning) if each.any())


def _mismatch(
    features: Features, residuals: np.ndarray, *, domain: str, axis: str, at: float, width: float
) -> Mismatch:
    squares = robust_squares(residuals[residuals != 0])
    return Mismatch(
        domain=domain, axis=axis, at=at, width=width, recordings=(features.observed.name,),
        excess_dB=10 * log10(max(float(squares.mean()), 1e-6)), share_of_misfit=1.0,
        p_value=float(chi2.sf(squares.sum(), squares.size)),
    )  # fmt: skip
