"""Backlash: a gap has no linear twin, so each width is simulated and the model's numbers are fitted around it.

What tells the width is how the flanks fly across it (``flights``), or, where an amplifier is too slow for blows, how
long and how often the torque stays near zero (``near_zero``).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.expecting.correction import between
from torquerig.diagnose.expecting.expectation import Expectation
from torquerig.diagnose.expecting.phased import with_phases_of
from torquerig.diagnose.expecting.simulated import expected_from, simulated_runs
from torquerig.diagnose.fitting.calibration import Calibrated, calibrated
from torquerig.diagnose.fitting.misfit import robust_squares
from torquerig.diagnose.linear.twin import Twin
from torquerig.diagnose.looking.features import Features
from torquerig.diagnose.looking.flight_statistics import flight_misfit, flight_statistics, longest_flight
from torquerig.diagnose.looking.flights import CLEARLY, blows, flights_counted
from torquerig.diagnose.looking.near_zero import near_zero_misfit, near_zero_stays
from torquerig.diagnose.looking.observed import Observed
from torquerig.diagnose.looking.without_tones import without_tones
from torquerig.diagnose.side_by_side import of_each
from torquerig.rig.rig import Rig
from torquerig.scenario.kinematics import gears_to_sensor

Floats = NDArray[np.float64]

ARCMIN = pi / 180 / 60
_GAPS = np.array([1.5, 3.0, 5.0, 8.0, 12.0, 18.0, 28.0, 45.0]) * ARCMIN  # [rad]
_BEYOND = 0.15  # [1] by which the gap may be wider than the longest flight across it
_FINE = np.geomspace(_GAPS[0], _GAPS[-1], 121)
_UNLOADED = 0.01  # share of samples below zero torque beyond which flanks part
_SUSPICIOUS = 2.5  # mean square residual of an unloaded run that asks for more than the twin
_LEAST_GAIN = 20.0  # by which flights or stays near zero torque must speak for a gap
_OF_A_BLOW = 150.0  # [Hz] a rise of 1.5 ms is a quarter of a period
_OF_ONE_BLOW = 1.2  # [1] of the logarithm of the energy: blows are unlike
_SEEDS = (1, 2)


@dataclass(frozen=True)
class FittedGap:
    """A gap, the model fitted around it, and the misfit of what tells its width, closed and open."""

    candidate: Candidate
    model: Calibrated
    closed: float
    opened: float


def gap_is_possible(case: Case) -> bool:
    """Whether flanks fly, or a run is fitted badly whose amplifier is too slow to show it, or whose gap is stated."""
    if not hasattr(mechanisms, "Backlash") or case.has("backlash") or not gears_to_sensor(case.nominal):
        return False
    if flanks_fly(case):
        return True
    poor = [
        float(np.mean(misfit.all() ** 2)) > _SUSPICIOUS
        for features, misfit in zip(case.seen, case.model.misfits, strict=True)
        if flanks_may_part(features) and (case.stated_gap or _blurred(case, features))
    ]
    return any(poor)


def flanks_fly(case: Case) -> bool:
    """Whether the recordings show more flights than a rig without a gap."""
    return sum(flights_counted(features.untoned) for features in case.seen) >= CLEARLY


def _blurred(case: Case, seen: Features) -> bool:
    """Whether the amplifier takes half of a blow away."""
    passed = Twin(case.model.rig.at(seen.observed.run)).amplifier(np.array([_OF_A_BLOW]))
    return bool(np.abs(passed[0]) < 0.5)


def flanks_may_part(seen: Features) -> bool:
    """Whether the torque of the run passes through zero, or near it, or rests there."""
    torque = seen.untoned.torque
    low = float(np.quantile(torque, _UNLOADED)) < 0.1 * float(np.abs(torque).mean())
    return low or flights_counted(seen.untoned) >= CLEARLY


def fitted_gap(case: Case, base: Rig) -> FittedGap | None:
    """Return the width whose simulations come nearest to the recordings, and the model fitted around it.

    None where the model without a gap comes as near.

    The numbers of the model are first fitted to what a gap leaves alone: loaded runs, and the slow torque of all. The
    width is then told, and all features are fitted once more, corrected for what the gap changes.
    """
    untouched = [_slow_part(features) if flanks_may_part(features) else features for features in case.seen]
    model = calibrated(base, untouched, case.model.knobs, start=np.zeros(len(case.model.knobs)))
    rigs = [with_phases_of(model.rig, features.observed) for features in case.seen]
    told = _width(case, rigs)
    if told is None:
        return None
    gap, closed, opened = told
    parted, copies = _simulated(case, rigs, gap)
    scatter = [_scatter(features, own) for features, own in zip(case.seen, copies, strict=True)]
    corrections = between(parted, _simulated(case, rigs, 0.0)[0], scatter=scatter)
    fitted = calibrated(
        base, case.seen, case.model.knobs, start=model.positions, corrections=corrections,
        jacobian=case.model.jacobian, near=False,
    )  # fmt: skip
    return FittedGap(_with_gap(case, gap), fitted, closed, opened)


def _slow_part(seen: Features) -> Features:
    """Keep of a run only what no gap changes: its level, or the blocks of a run that turns back."""
    if seen.turning is not None:
        return seen
    return replace(
        seen, amplitude=np.full(seen.amplitude.shape, np.nan, dtype=complex), power=np.full(seen.power.shape, np.nan)
    )


def _simulated(case: Case, rigs: Sequence[Rig], gap: float) -> tuple[tuple[Expectation, ...], list[list[Observed]]]:
    """Return what simulations with this gap expect of every run, and the simulations."""
    opened = [_with_gap(case, gap).added_to(rig) for rig in rigs]
    copies = simulated_runs(opened, case.seen, seeds=_SEEDS[:1])
    return expected_from(opened[0], case.seen, copies), copies


def _scatter(seen: Features, copies: Sequence[Observed]) -> float:
    """Return what the numbers of blows in the run and in its copies leave of its density's logarithm to chance [1]."""
    if not flanks_may_part(seen):
        return 0.0
    there = len(blows(seen.untoned))
    here = sum(len(blows(without_tones(copy, seen.places), held=None)) for copy in copies)
    return _OF_ONE_BLOW * float(np.sqrt(1 / (1 + there) + 1 / (1 + here)))


def _width(case: Case, rigs: Sequence[Rig]) -> tuple[float, float, float] | None:
    """Return the gap [rad] that comes nearest to the recordings, and the misfit without and with it.

    Where too few flights are quiet enough to tell, because the shafts ring meanwhile, the stays near zero are asked. Of
    a gap that the scenario states, the stated width is taken where neither tells it.
    """
    told = _told_by(case, rigs, flying=True) if flanks_fly(case) else None
    told = _told_by(case, rigs, flying=False) if told is None else told
    return (case.stated_gap, 0.0, 0.0) if told is None and case.stated_gap else told


def _told_by(case: Case, rigs: Sequence[Rig], *, flying: bool) -> tuple[float, float, float] | None:
    """Return the width as flights tell it, or else stays near zero, with the misfit without and with it."""
    parting = [row for row, features in enumerate(case.seen) if flanks_may_part(features)]
    seen = [case.seen[row] for row in parting]
    statistics = partial(flight_statistics, rig=case.nominal) if flying else near_zero_stays
    apart = flight_misfit if flying else near_zero_misfit
    told = [statistics(features.untoned) for features in seen]

    def shown(rigs: Sequence[Rig]) -> Floats:
        pairs = list(zip(seen, simulated_runs(rigs, seen, seeds=_SEEDS), strict=True))
        return np.array(of_each(lambda pair: _mean_of(statistics, *pair), pairs))

    def cost(modelled: Floats) -> float:
        pairs = zip(told, modelled, strict=True)
        return float(sum(robust_squares(apart(measured, model)).sum() for measured, model in pairs))

    closed = cost(shown([rigs[row] for row in parting]))
    if closed < _LEAST_GAIN:
        return None
    each = np.array([shown([_with_gap(case, float(gap)).added_to(rigs[row]) for row in parting]) for gap in _GAPS])
    course = _smoothed(each)
    costs = np.array([cost(modelled) for modelled in course])
    longest = longest_flight([features.untoned for features in seen], case.nominal) if flanks_fly(case) else np.inf
    at = int(np.argmin(costs + (np.log(np.maximum(_FINE / longest, 1.0)) / _BEYOND) ** 2))
    return (float(_FINE[at]), closed, float(costs[at])) if costs[at] < closed - _LEAST_GAIN else None


def _mean_of(statistics: Callable[[Observed], Floats], seen: Features, copies: Sequence[Observed]) -> Floats:
    """Return the mean of the statistics of a run's simulations."""
    return np.asarray(np.mean([statistics(without_tones(copy, seen.places)) for copy in copies], axis=0))


def _smoothed(each: Floats) -> Floats:
    """Return statistics at fine steps of the gap, shape (fine, ...), from those at ``_GAPS``, shape (gaps, ...).

    Two simulations with one gap differ by chance more than those of neighbouring gaps should, so each statistic is
    taken as a parabola over the gap's logarithm.
    """
    bent = np.polynomial.polynomial.polyfit(np.log(_GAPS), each.reshape(_GAPS.size, -1), 2)
    at_each = np.polynomial.polynomial.polyval(np.log(_FINE), bent).T
    return np.asarray(at_each.reshape(_FINE.size, *each.shape[1:]))


def _with_gap(case: Case, gap: float) -> Candidate:
    gear = gears_to_sensor(case.nominal)[-1]
    part = mechanisms.Backlash(name="backlash", gear=gear.name, gap=gap)
    return Candidate(mechanism="backlash", parts=(part,), knobs=())


def simulated_model(candidate: Candidate, model: Calibrated) -> Calibrated:
    """Return the model with the candidate's parts in its rig: what is simulated, and written."""
    return replace(model, rig=candidate.added_to(model.rig))
