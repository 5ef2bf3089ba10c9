"""The model's numbers fitted around a gap of a given width, which has no linear twin and is simulated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing.opened_gap import flanks_may_part, gap_of, opened
from torquerig.diagnosis.expecting.correction import Correction, between
from torquerig.diagnosis.expecting.expectation import Expectation
from torquerig.diagnosis.expecting.phased import with_phases_of
from torquerig.diagnosis.expecting.simulated import expected_from, simulated_runs
from torquerig.diagnosis.fitting.calibration import MOST_DERIVATIVES, Calibrated, calibrated
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.flight_statistics import chance_of_amplitudes, chance_of_blows
from torquerig.diagnosis.looking.flights import blows
from torquerig.diagnosis.looking.from_zero import undrifted
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.without_tones import without_tones
from torquerig.rig.assembly import Rig

_SEEDS = (1,)


@dataclass(frozen=True)
class FittedGap:
    """A gap, the model fitted around it, and the misfit of what tells its width, closed and open."""

    candidate: Candidate
    model: Calibrated
    closed: float = 0.0
    opened: float = 0.0

    @property
    def gap(self) -> float:
        """Its width [rad]."""
        return gap_of(self.candidate)


def left_alone(case: Case, base: Rig) -> Calibrated:
    """Return ``base`` fitted to what a gap leaves alone: loaded runs, and the slow torque of all."""
    parting = [flanks_may_part(features) for features in case.from_zero]
    untouched = [_slow_part(each) if parts else each for each, parts in zip(case.seen, parting, strict=True)]
    return calibrated(base, untouched, case.model.knobs, start=np.zeros(len(case.model.knobs)))


def simulated_rigs(case: Case, model: Calibrated) -> list[Rig]:
    """Return the model's rig as it is simulated for each run, its lines in the phases that they have there."""
    return [with_phases_of(model.rig, features.observed) for features in case.seen]


class GapFits:
    """Fits around gaps of any width.

    All features are fitted, corrected for what the gap changes in simulations.

    Parameters
    ----------
    case : Case
    base : Rig
        Nominal, with what was accepted before.
    alone : Calibrated
        Fitted to what a gap leaves alone (``left_alone``): where the fits begin.
    rigs : sequence of Rig
        The same as it is simulated for each run (``simulated_rigs``).
    """

    def __init__(self, case: Case, base: Rig, alone: Calibrated, rigs: Sequence[Rig]) -> None:
        self.case, self._base, self._alone, self._rigs = case, base, alone, rigs
        self._closed = self._simulated(0.0)[0]

    def around(self, gap: float, *, derivatives: int = MOST_DERIVATIVES) -> FittedGap:
        """Return the fit around a gap [rad], by so many sets of derivatives at the most."""
        parted, copies = self._simulated(gap)
        scatter = [_scatter(*each) for each in zip(self.case.from_zero, copies, self._rigs, strict=True)]
        corrections = [
            replace(each, beside=_beside(seen))
            for each, seen in zip(between(parted, self._closed, scatter=scatter), self.case.from_zero, strict=True)
        ]
        return FittedGap(opened(self.case, gap), self._fitted(self._alone.positions, corrections, derivatives))

    def better(self, rough: FittedGap) -> FittedGap:
        """Return a fit that is made from where a rough one ended."""
        model = self._fitted(rough.model.positions, rough.model.corrections, MOST_DERIVATIVES)
        return replace(rough, model=model)

    def _fitted(self, start: NDArray[np.float64], corrections: Sequence[Correction], derivatives: int) -> Calibrated:
        return calibrated(
            self._base, self.case.seen, self.case.model.knobs, start=start, corrections=corrections,
            jacobian=self.case.model.jacobian, derivatives=derivatives,
        )  # fmt: skip

    def _simulated(self, gap: float) -> tuple[tuple[Expectation, ...], list[list[Observed]]]:
        """Return what simulations with this gap expect of every run, and the simulations."""
        parting = [opened(self.case, gap).added_to(rig) for rig in self._rigs]
        copies = simulated_runs(parting, self.case.seen, seeds=_SEEDS)
        return expected_from(parting[0], self.case.seen, copies), copies


def _slow_part(seen: Features) -> Features:
    """Keep of a run only what no gap changes: its level, or the blocks of a run that turns back."""
    if seen.turning is not None:
        return seen
    return replace(seen.without(seen.places), power=np.full(seen.power.shape, np.nan))


def _beside(seen: Features) -> NDArray[np.float64] | float:
    """Return what the blows that a run shows leave of the square of any amplitude to chance [(N m)^2]."""
    return chance_of_amplitudes(seen) if flanks_may_part(seen) and blows(seen.untoned, held=None) else 0.0


def _scatter(seen: Features, copies: Sequence[Observed], rig: Rig) -> float:
    """Return what the numbers of blows in the run and in its copies leave of its density's logarithm to chance [1]."""
    if not flanks_may_part(seen):
        return 0.0
    there = len(blows(seen.untoned))
    still = [undrifted(copy, rig) for copy in copies]
    here = sum(len(blows(without_tones(copy, seen.places), held=None)) for copy in still)
    return chance_of_blows(there, here)
