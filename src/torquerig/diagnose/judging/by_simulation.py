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
from torquerig.diagnose.looking.flights import CLEARLY, flights_counted
from torquerig.diagnose.looking.flights_beyond_lines import flights_beyond_lines
from torquerig.diagnose.looking.observed import Observed
from torquerig.diagnose.looking.without_tones import without_tones
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
    found = mismatches(simulated, beyond)
    again = [each for each in found if each.domain != "distribution" or _flies_more(case, copies)]
    return tuple(mismatch for mismatch in left if any(_same(mismatch, other) for other in again))


def _flies_more(case: Case, copies: Sequence[Sequence[Observed]]) -> bool:
    """Whether recordings show clearly more flights than simulations, whose lines pass near zero at the same moments."""
    shown = sum(flights_beyond_lines(features) for features in case.seen)
    made = sum(
        flights_counted(without_tones(each[0], features.places))
        for features, each in zip(case.seen, copies, strict=True)
    )
    return shown - made >= CLEARLY


def _same(one: Mismatch, other: Mismatch) -> bool:
    """Whether two mismatches tell of one thing; a run misses its mean torque once, wherever it misses most."""
    alike = one.domain == other.domain and one.axis == other.axis and bool({*one.recordings} & {*other.recordings})
    of_the_run = one.domain in ("speed", "level")
    return alike and (of_the_run or abs(one.at - other.at) <= 0.5 * (one.width + other.width))
