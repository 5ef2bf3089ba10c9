"""Recording, model before and model after beside each other, on the stretches that no fit has seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.expecting.expectation import Expectation
from torquerig.diagnosis.expecting.phased import as_in_runs, phases_tell
from torquerig.diagnosis.expecting.simulated import expected_from, simulated_runs
from torquerig.diagnosis.fitting.misfit import Misfit, misfit, robust_squares
from torquerig.diagnosis.judging.held_out import SEEDS
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Side:
    """One model beside one run: a simulation of the run, what it expects, and how far the recording lies from it."""

    copy: Observed
    expected: Expectation
    misfit: Misfit

    @property
    def mean_square(self) -> float:
        """Mean of the squares of the robust residuals, below 1 for a true model."""
        residuals = self.misfit.all()
        return float(np.mean(robust_squares(residuals))) if residuals.size else 0.0


@dataclass(frozen=True)
class Compared:
    """The held-out stretches of one run, with the model before (calibrated) and after (completed)."""

    held: Features
    before: Side
    after: Side

    @property
    def gained(self) -> float:
        """By how much the mean square falls."""
        return self.before.mean_square - self.after.mean_square


def compared(outcome: Outcome) -> tuple[Compared, ...]:
    """Return every run beside simulations of both models; one model alone where nothing was found."""
    flying = phases_tell(outcome.completed)
    before = _sides(outcome.before.model.rig, outcome.held, flying=flying)
    after = before if not outcome.diagnosis.findings else _sides(outcome.completed, outcome.held, flying=flying)
    return tuple(Compared(*three) for three in zip(outcome.held, before, after, strict=True))


def most_telling(runs: Sequence[Compared]) -> Compared | None:
    """Return the run whose spectrum shows most of what was found: steady where there is one; None without any."""
    lines = [one for one in runs if one.held.turning is None]
    return max(lines, key=lambda one: (one.held.observed.steady, one.gained), default=None)


def _sides(rig: Rig, held: Sequence[Features], *, flying: bool) -> list[Side]:
    rigs = as_in_runs(rig, held) if flying else rig
    copies = [each[0] for each in simulated_runs(rigs, held, seeds=SEEDS[:1])]
    models = expected_from(rig, held, [[copy] for copy in copies])
    return [
        Side(copy, model, misfit(features, model)) for copy, model, features in zip(copies, models, held, strict=True)
    ]
