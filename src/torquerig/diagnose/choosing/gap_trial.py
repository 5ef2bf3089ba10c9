"""Backlash: a gap has no linear twin, so it is simulated and the model's numbers are fitted around it.

Flights, or stays near zero torque, tell its width (``gap_width``). Flanks that chatter and never cross leave their
spectrum alone, which tells that there is a gap and at the most how wide it is at least.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.choosing.gap_width import width
from torquerig.diagnose.choosing.opened_gap import ARCMIN, flanks_fly, flanks_may_part, opened
from torquerig.diagnose.expecting.correction import Correction, between
from torquerig.diagnose.expecting.expectation import Expectation
from torquerig.diagnose.expecting.phased import with_phases_of
from torquerig.diagnose.expecting.simulated import expected_from, simulated_runs
from torquerig.diagnose.fitting.calibration import MOST_DERIVATIVES, Calibrated, calibrated
from torquerig.diagnose.looking.features import Features
from torquerig.diagnose.looking.flight_statistics import chance_of_blows
from torquerig.diagnose.looking.flights import blows
from torquerig.diagnose.looking.observed import Observed
from torquerig.diagnose.looking.without_tones import without_tones
from torquerig.diagnose.side_by_side import of_each
from torquerig.rig.rig import Rig
from torquerig.scenario.kinematics import gears_to_sensor

_CHATTERING = (1.5, 5.0, 15.0, 45.0)  # [arcmin] over what gaps in service are
_ALIKE = 4.0  # of the misfit: 95 % of one number
_SUSPICIOUS = 2.5  # mean square residual of an unloaded run that asks for more than the twin
_LEFT = 1.5  # the same, below which chatter explains it: moments of another kind would leave more
_HOPELESS = 20.0  # the same, which no further fit brings down so far
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
        (part,) = self.candidate.parts
        assert isinstance(part, mechanisms.Backlash)
        return part.gap


def gap_is_possible(case: Case) -> bool:
    """Whether flanks fly, or a run is fitted badly in which they may part."""
    if not hasattr(mechanisms, "Backlash") or case.has("backlash") or not gears_to_sensor(case.nominal):
        return False
    if flanks_fly(case):
        return True
    return max(_unexplained(case, case.model), default=0.0) > _SUSPICIOUS


def fitted_gap(case: Case, base: Rig) -> FittedGap | None:
    """Return the gap whose simulations come nearest to the recordings, and the model fitted around it.

    None where neither flights nor stays near zero tell one, and chatter leaves a run unexplained where flanks may part,
    or another effect is in the model, or coarse codes are: what those leave may look like chatter.

    The numbers of the model are first fitted to what a gap leaves alone: loaded runs, and the slow torque of all. The
    width is then told, and all features are fitted once more, corrected for what the gap changes. A gap that the
    scenario states has the stated width where nothing tells another. Gaps that chatter are fitted roughly at first, and
    on only where that brings them anywhere near the recordings.
    """
    untouched = [_slow_part(features) if flanks_may_part(features) else features for features in case.seen]
    model = calibrated(base, untouched, case.model.knobs, start=np.zeros(len(case.model.knobs)))
    rigs = [with_phases_of(model.rig, features.observed) for features in case.seen]
    told = width(case, rigs)
    if told is None and not case.stated_gap and (case.accepted or case.nominal.parts_of(mechanisms.Quantization)):
        return None
    closed = _simulated(case, rigs, 0.0)[0]

    def fitted_on(start: NDArray[np.float64], corrections: Sequence[Correction], derivatives: int) -> Calibrated:
        return calibrated(
            base, case.seen, case.model.knobs, start=start, corrections=corrections, jacobian=case.model.jacobian,
            derivatives=derivatives,
        )  # fmt: skip

    def around(gap: float, *, derivatives: int = MOST_DERIVATIVES) -> FittedGap:
        parted, copies = _simulated(case, rigs, gap)
        scatter = [_scatter(features, own) for features, own in zip(case.seen, copies, strict=True)]
        corrections = between(parted, closed, scatter=scatter)
        return FittedGap(opened(case, gap), fitted_on(model.positions, corrections, derivatives))

    def better(rough: FittedGap) -> FittedGap:
        found = fitted_on(rough.model.positions, rough.model.corrections, MOST_DERIVATIVES)
        return replace(rough, model=found)

    if told is not None:
        width_told = opened(case, told.gap, within=told.within)
        return replace(around(told.gap), candidate=width_told, closed=told.closed, opened=told.opened)
    if case.stated_gap:
        return around(case.stated_gap)
    roughly = of_each(lambda gap: around(gap * ARCMIN, derivatives=1), _CHATTERING)
    hopeful = [rough for rough in roughly if max(_unexplained(case, rough.model), default=np.inf) < _HOPELESS]
    if not hopeful:
        return None
    best = _of_like(case, of_each(better, hopeful))
    return best if max(_unexplained(case, best.model)) < _LEFT else None


def _unexplained(case: Case, model: Calibrated) -> list[float]:
    """Return the mean square residual of each run in which flanks may part."""
    pairs = zip(case.seen, model.misfits, strict=True)
    return [float(np.mean(misfit.all() ** 2)) for features, misfit in pairs if flanks_may_part(features)]


def _of_like(case: Case, fits: Sequence[FittedGap]) -> FittedGap:
    """Return the best of the fits, its gap in the middle of those that fit as well."""
    best = min(fits, key=lambda fit: fit.model.cost)
    alike = [fit.gap for fit in fits if fit.model.cost < best.model.cost + _ALIKE]
    if len(alike) < 2:
        return best
    within = (min(alike), max(alike))
    return replace(best, candidate=opened(case, sqrt(within[0] * within[1]), within=within))


def _slow_part(seen: Features) -> Features:
    """Keep of a run only what no gap changes: its level, or the blocks of a run that turns back."""
    if seen.turning is not None:
        return seen
    return replace(seen.without(seen.places), power=np.full(seen.power.shape, np.nan))


def _simulated(case: Case, rigs: Sequence[Rig], gap: float) -> tuple[tuple[Expectation, ...], list[list[Observed]]]:
    """Return what simulations with this gap expect of every run, and the simulations."""
    parting = [opened(case, gap).added_to(rig) for rig in rigs]
    copies = simulated_runs(parting, case.seen, seeds=_SEEDS)
    return expected_from(parting[0], case.seen, copies), copies


def _scatter(seen: Features, copies: Sequence[Observed]) -> float:
    """Return what the numbers of blows in the run and in its copies leave of its density's logarithm to chance [1]."""
    if not flanks_may_part(seen):
        return 0.0
    there = len(blows(seen.untoned))
    here = sum(len(blows(without_tones(copy, seen.places), held=None)) for copy in copies)
    return chance_of_blows(there, here)


def simulated_model(candidate: Candidate, model: Calibrated) -> Calibrated:
    """Return the model with the candidate's parts in its rig: what is simulated, and written."""
    return replace(model, rig=candidate.added_to(model.rig))
