"""Whether what a linear twin leaves is there in simulations of its rig as well: only then is something missing.

A strong ripple turns the shaft so far that it shifts its own phase, and makes lines at twice its order; a hit may part
flanks or reach the converter's limit. The rig has that, its twin has not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.correction import Correction, between
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.expecting.phased import with_phases_of
from torquerig.diagnosis.expecting.simulated import expected_from, simulated_runs
from torquerig.diagnosis.fitting.calibration import misfits_of
from torquerig.diagnosis.fitting.misfit import misfit_sum
from torquerig.diagnosis.judging.leftover import mismatches
from torquerig.diagnosis.looking.flights import CLEARLY, flights_counted
from torquerig.diagnosis.looking.flights_beyond_lines import flights_beyond_lines
from torquerig.diagnosis.looking.from_zero import undrifted
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.without_tones import without_tones
from torquerig.errors import SimulationError
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.rig.assembly import Rig

_SEEDS = (11,)
_OF_RINGS = 0.03  # of a bearing's impacts may look like flights


def left_by_simulation(case: Case, left: Sequence[Mismatch]) -> tuple[Mismatch, ...]:
    """Return what of ``left`` stands out where the case's rig is simulated instead; all of it where it cannot be."""
    if not left:
        return ()
    try:
        return _still_there(case, left, *_beyond_the_twin(case))
    except SimulationError:
        return tuple(left)


def left_and_fall(case: Case, left: Sequence[Mismatch], other: Rig) -> tuple[tuple[Mismatch, ...], float]:
    """Return the same, and by how much the misfit falls with another rig beside what only simulations have.

    Of the slow torque of a steady run under load that is the load's chance, and left out. It falls by 0 where the
    case's rig cannot be simulated: nothing then speaks for the other.
    """
    try:
        copies, beyond = _beyond_the_twin(case)
    except SimulationError:
        return tuple(left), 0.0
    told = [
        replace(each, level=np.zeros_like(each.level)) if _random(features.observed) else each
        for each, features in zip(beyond, case.seen, strict=True)
    ]
    before, after = (misfits_of(rig, case.seen, told) for rig in (case.model.rig, other))
    return _still_there(case, left, copies, beyond), misfit_sum(before) - misfit_sum(after)


def _still_there(
    case: Case, left: Sequence[Mismatch], copies: Sequence[Sequence[Observed]], beyond: Sequence[Correction]
) -> tuple[Mismatch, ...]:
    simulated = replace(case, model=replace(case.model, misfits=misfits_of(case.model.rig, case.seen, beyond)))
    found = mismatches(simulated, beyond)
    again = [each for each in found if each.domain != "distribution" or _flies_more(case, copies)]
    return tuple(mismatch for mismatch in left if any(_same(mismatch, other) for other in again))


def _random(run: Observed) -> bool:
    """Whether the slow torque of a run goes as chance has its load."""
    return run.steady and bool(run.run.occupancy_percent)


def _beyond_the_twin(case: Case) -> tuple[list[list[Observed]], list[Correction]]:
    """Return simulations of the case's rig, one list a run, and what they have beyond its twin."""
    rig = case.model.rig
    rigs = [with_phases_of(rig, features.observed) for features in case.seen]
    copies = simulated_runs(rigs, case.seen, seeds=_SEEDS)
    twin = [expected(rig, features) for features in case.seen]
    scatter = [each.scatter for each in case.model.corrections]
    return copies, between(expected_from(rig, case.seen, copies), twin, scatter=scatter)


def _flies_more(case: Case, copies: Sequence[Sequence[Observed]]) -> bool:
    """Whether recordings show clearly more flights than simulations, whose lines pass near zero at the same moments.

    Of a bearing's rings, which differ in size as those of a simulation do not, a few look like blows after a rest.
    """
    shown = sum(flights_beyond_lines(features) for features in case.from_zero)
    made = sum(
        flights_counted(without_tones(undrifted(each[0], case.model.rig), features.places))
        for features, each in zip(case.seen, copies, strict=True)
    )
    return shown - made >= CLEARLY + _OF_RINGS * _rings(case)


def _rings(case: Case) -> float:
    """Return how many impacts of bearings in the model the runs show."""
    struck = sum(part.order_output for part in case.model.rig.of_kind("bearing_defect"))
    turned = sum(np.ptp(features.observed.angle[features.observed.seen]) for features in case.seen)
    return float(struck * turned / (2 * np.pi * abs(case.nominal.run.gear_ratio or 1.0)))


def _same(one: Mismatch, other: Mismatch) -> bool:
    """Whether two mismatches tell of one thing; a run misses its mean torque once, wherever it misses most."""
    alike = one.domain == other.domain and one.axis == other.axis and bool({*one.recordings} & {*other.recordings})
    of_the_run = one.domain in ("speed", "level")
    return alike and (of_the_run or abs(one.at - other.at) <= 0.5 * (one.width + other.width))
