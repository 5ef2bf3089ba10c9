"""Whether what a linear twin leaves is there in simulations of its rig as well: only then is something missing.

A strong ripple turns the shaft so far that it shifts its own phase, and makes lines at twice its order; a hit may part
flanks or reach the converter's limit. The rig has that, its twin has not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.diagnose.case import Case
from torquerig.diagnose.diagnosis import Mismatch
from torquerig.diagnose.expecting.correction import between
from torquerig.diagnose.expecting.expectation import expected
from torquerig.diagnose.expecting.phased import with_phases_of
from torquerig.diagnose.expecting.simulated import expected_from, simulated_runs
from torquerig.diagnose.fitting.calibration import misfits_of
from torquerig.diagnose.judging.leftover import mismatches
from torquerig.errors import SimulationError

_SEEDS = (11,)


def left_by_simulation(case: Case, left: Sequence[Mismatch]) -> tuple[Mismatch, ...]:
    """Return what of ``left`` stands out where the case's rig is simulated instead; all of it where it cannot be."""
    if not left:
        return ()
    rig = case.model.rig
    rigs = [with_phases_of(rig, features.observed) for features in case.seen]
    try:
        copies = simulated_runs(rigs, case.seen, seeds=_SEEDS)
    except SimulationError:
        return tuple(left)
    twin = [expected(rig, features) for features in case.seen]
    scatter = [each.scatter for each in case.model.corrections]
    beyond = between(expected_from(rig, case.seen, copies), twin, scatter=scatter)
    simulated = replace(case, model=replace(case.model, misfits=misfits_of(rig, case.seen, beyond)))
    again = mismatches(simulated)
    return tuple(mismatch for mismatch in left if any(_same(mismatch, other) for other in again))


def _same(one: Mismatch, other: Mismatch) -> bool:
    alike = one.domain == other.domain and one.axis == other.axis and bool({*one.recordings} & {*other.recordings})
    return alike and abs(one.at - other.at) <= 0.5 * (one.width + other.width)
