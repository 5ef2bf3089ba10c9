"""Backlash: a gap has no linear twin, so each width is simulated and the model's numbers are fitted around it."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnose.calibration import Calibrated, calibrated, misfits_of
from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.correction import between
from torquerig.diagnose.features import Features
from torquerig.diagnose.misfit import misfit_sum
from torquerig.diagnose.simulated import expected_by_simulation
from torquerig.rig.rig import Rig
from torquerig.scenario.kinematics import gears_to_sensor

ARCMIN = pi / 180 / 60
_GAPS = np.array([1.0, 3.0, 6.0, 12.0, 24.0, 48.0]) * ARCMIN  # [rad]
_REFINED = (0.6, 0.8, 1.25, 1.6)
_UNLOADED = 0.01  # share of samples below zero torque beyond which flanks part
_SUSPICIOUS = 2.5  # mean square residual of an unloaded run that asks for more than the twin
_SEEDS = (1,)


def gap_is_possible(case: Case) -> bool:
    """Whether a run in which flanks may part is fitted badly; elsewhere a gap changes nothing."""
    if not hasattr(mechanisms, "Backlash") or case.has("backlash") or not gears_to_sensor(case.nominal):
        return False
    poor = [
        float(np.mean(misfit.all() ** 2)) > _SUSPICIOUS
        for features, misfit in zip(case.seen, case.model.misfits, strict=True)
        if flanks_may_part(features)
    ]
    return any(poor)


def flanks_may_part(seen: Features) -> bool:
    """Whether the torque of the run passes through zero, or near it."""
    torque = seen.observed.torque
    return float(np.quantile(torque, _UNLOADED)) < 0.1 * float(np.abs(torque).mean())


def fitted_gap(case: Case, base: Rig) -> tuple[Candidate, Calibrated]:
    """Return the width that fits best and the model fitted around it.

    The numbers of the model are first fitted to loaded runs alone, where a gap stays closed; then all runs, corrected
    for what the gap changes, and the width once more around the best.
    """
    loaded = [features for features in case.seen if not flanks_may_part(features)]
    start = np.zeros(len(case.model.knobs))
    model = calibrated(base, loaded, case.model.knobs, start=start) if loaded else case.model
    gap, model = _best(case, base, model, _GAPS)
    gap, model = _best(case, base, model, np.array([gap, *(gap * factor for factor in _REFINED)]))
    return _with_gap(case, gap), model


def _best(case: Case, base: Rig, model: Calibrated, gaps: NDArray[np.float64]) -> tuple[float, Calibrated]:
    closed = expected_by_simulation(model.rig, case.seen, seeds=_SEEDS)
    tried = []
    for gap in gaps:
        opened = expected_by_simulation(_with_gap(case, gap).added_to(model.rig), case.seen, seeds=_SEEDS)
        correction = between(opened, closed)
        tried.append((misfit_sum(misfits_of(model.rig, case.seen, correction)), float(gap), correction))
    _, gap, correction = min(tried, key=lambda item: item[0])
    return gap, calibrated(base, case.seen, case.model.knobs, start=model.positions, corrections=correction)


def _with_gap(case: Case, gap: float) -> Candidate:
    gear = gears_to_sensor(case.nominal)[-1]
    part = mechanisms.Backlash(name="backlash", gear=gear.name, gap=gap)
    return Candidate(mechanism="backlash", parts=(part,), knobs=())


def simulated_model(candidate: Candidate, model: Calibrated) -> Calibrated:
    """Return the model with the candidate's parts in its rig: what is simulated, and written."""
    return replace(model, rig=candidate.added_to(model.rig))
