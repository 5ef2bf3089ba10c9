"""Which rivals these recordings cannot tell from the best: the difference of the misfits against its own spread."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.choosing.trial import PER_KNOB, Trial
from torquerig.diagnosis.fitting.calibration import Calibrated, misfits_of
from torquerig.diagnosis.fitting.misfit import Misfit, robust
from torquerig.diagnosis.looking.features import Features

Floats = NDArray[np.float64]

CHANCE = 2.33  # spreads by which a rival must be worse to be excluded: chance does so once in a hundred
_BLOCK = 4  # neighbouring features that may stray together


@dataclass(frozen=True)
class Difference:
    """By how much one model fits worse than another on the same features.

    Parameters
    ----------
    excess : float
        Sum of squares of the robust residuals, the rival's less the better one's [1].
    spread : float
        One sigma that chance puts on ``excess`` [1].
    apart : float
        How far the two models lie apart, in units of the features' spread [1].
    """

    excess: float
    spread: float
    apart: float


def difference(
    better: Sequence[Misfit], rival: Sequence[Misfit], *, also: tuple[Floats, Floats] | None = None
) -> Difference:
    """Return how much worse ``rival`` fits the runs than ``better``, with its sampling spread.

    Residuals a of the better model and b = a + d of the rival differ by d, which no chance moves; then
    sum(b^2) - sum(a^2) = sum(d^2) + 2 sum(a d), and only the last sum is random. Its spread follows from residuals of
    unit spread, or from those that are there, neighbours taken together, where these stray further (Vuong 1989,
    Econometrica 57(2), eq. 4.2; White 1982, Econometrica 50(1), for the sum over blocks).

    Parameters
    ----------
    better, rival : sequence of Misfit
        One per run.
    also : pair of ndarray, shape (numbers,), optional
        Positions of the numbers that both models fitted, which count as residuals.
    """
    groups = list(_groups(better, rival))
    if also is not None:
        groups += [(np.array([one]), np.array([other])) for one, other in zip(*also, strict=True)]
    excess = plain = strayed = 0.0
    for one, other in groups:
        step = other - one
        excess += float((other**2 - one**2).sum())
        plain += float((step**2).sum())
        strayed += sum(
            float((one[at : at + _BLOCK] @ step[at : at + _BLOCK]) ** 2) for at in range(0, one.size, _BLOCK)
        )
    return Difference(excess, 2 * sqrt(max(plain, strayed)), sqrt(plain))


def alike(best: Trial, rival: Trial, held: Sequence[Features] = ()) -> bool:
    """Whether the rival fits within chance as well as the best, on what was fitted and on what was held out."""
    seen = difference(best.model.misfits, rival.model.misfits, also=_shared(best.model, rival.model))
    parts = [seen]
    if held and not best.model.corrections and not rival.model.corrections:
        parts.append(difference(misfits_of(best.model.rig, held), misfits_of(rival.model.rig, held)))
    paid = PER_KNOB * (len(rival.candidate.knobs) - len(best.candidate.knobs))
    excess = sum(part.excess for part in parts) + paid
    return excess <= CHANCE * sqrt(sum(part.spread**2 for part in parts))


def _shared(best: Calibrated, rival: Calibrated) -> tuple[Floats, Floats]:
    """Return the positions of the numbers that both models have: a dropped effect took its own along."""
    mine, its = (
        {knob.name: float(at) for knob, at in zip(model.knobs, model.positions, strict=True)} for model in (best, rival)
    )
    names = [name for name in mine if name in its]
    return np.array([mine[name] for name in names]), np.array([its[name] for name in names])


def equivalents(best: Trial, others: Sequence[Trial], held: Sequence[Features] = ()) -> tuple[Trial, ...]:
    """Return of each other mechanism the best trial, where these recordings cannot tell it from ``best``."""
    found: dict[str, Trial] = {}
    for trial in others:
        name = trial.candidate.mechanism
        if name != best.candidate.mechanism and name not in found and trial.gain > 0 and alike(best, trial, held):
            found[name] = trial
    return tuple(found.values())


def _groups(better: Sequence[Misfit], rival: Sequence[Misfit]) -> Iterator[tuple[Floats, Floats]]:
    """Yield robust residuals of both models, neighbours in one row."""
    for one, other in zip(better, rival, strict=True):
        yield robust(one.bands), robust(other.bands)
        yield robust(one.level), robust(other.level)
        yield robust(one.turning), robust(other.turning)
        for column in zip(np.atleast_2d(one.lines).T, np.atleast_2d(other.lines).T, strict=True):
            yield robust(column[0]), robust(column[1])
