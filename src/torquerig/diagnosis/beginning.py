"""Where a search begins: the nominal model calibrated, of the rig that fits where a catalog leaves counts open.

A motor whose maker states no pole pairs is drawn with one of a few counts. Lines at the orders of another count are no
missing physics: every rig that the catalog allows is calibrated, and the one whose model misses least is diagnosed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.search import excess
from torquerig.diagnosis.choosing.trial import LEAST_GAIN
from torquerig.diagnosis.free_names import with_free_names
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.null_table import null_table, without_table
from torquerig.diagnosis.opening import followed, opened
from torquerig.diagnosis.own_gap import OwnGap, closed
from torquerig.diagnosis.sample_findings import SampleFindings, sample_findings
from torquerig.diagnosis.sentences import MECHANISMS
from torquerig.diagnosis.set_points import off_set_points
from torquerig.diagnosis.sheet_ratio import off_ratios
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.knobs import unvaried, with_free_load
from torquerig.inference.rig_under_test import check_recordings, check_rig
from torquerig.parallel import parallel_map
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.gear_ratio import at_ratio_of

Progress = Callable[[str], None]


@dataclass(frozen=True, kw_only=True)
class Beginning:
    """What a search begins with.

    Parameters
    ----------
    scenario : Scenario
        As it was read, with names for what may be found.
    whole : Rig
        The scenario's rig, a gap that it states included.
    own_gap : OwnGap or None
        That gap, which is closed in ``before``.
    faults : SampleFindings
    runs : tuple of Observed
    untrue : tuple of (str, Mismatch)
        What cannot be true of recordings or sheets, in words and located.
    before : Case
        The nominal model, calibrated.
    held : tuple of Features
        Of the stretches that no fit has seen.
    remarks : tuple of str
        Which counts fit, and what is not known of the scenario.
    """

    scenario: Scenario
    whole: Rig
    own_gap: OwnGap | None
    faults: SampleFindings
    runs: tuple[Observed, ...]
    untrue: tuple[tuple[str, Mismatch], ...]
    before: Case
    held: tuple[Features, ...]
    remarks: tuple[str, ...] = ()

    def of_fitted_runs(self) -> tuple[Features, ...]:
        """Those of ``held`` whose runs fits have seen elsewhere."""
        fitted = {run.name for run in self.before.runs}
        return tuple(each for each in self.held if each.observed.name in fitted)


def begun(
    scenario: Scenario, others: Sequence[Scenario], recordings: Sequence[Recording], progress: Progress
) -> Beginning:
    """Return the beginning of the scenario, or of one of the ``others`` where that fits clearly better."""
    drawn = _begun(scenario, recordings, progress)
    if not others:
        return drawn
    progress(f"testing {len(others)} other samples of the open catalog values")
    left_by = parallel_map(lambda other: excess(_begun(other, recordings, lambda _: None).before), others)
    least = int(np.argmin(left_by))
    if left_by[least] >= excess(drawn.before) - LEAST_GAIN:
        return drawn
    best = _begun(others[least], recordings, progress)
    chosen, left = best.scenario.choices(), drawn.scenario.choices()
    told = [f"{name} = {of:g} (drawn: {left[name]:g})" for name, of in chosen.items() if left.get(name) != of]
    said = f"The catalog leaves values open. The recordings fit {', '.join(told) or 'another sample of them'} best."
    return replace(best, remarks=(said, *best.remarks))


def _begun(scenario: Scenario, recordings: Sequence[Recording], progress: Progress) -> Beginning:
    thresholds, unknown = null_table(scenario), without_table(scenario)
    scenario = with_free_names(scenario, MECHANISMS)
    check_rig(scenario.rig)
    check_recordings(recordings)
    sheets, recordings = recordings, at_ratio_of(recordings, scenario.rig)
    whole = with_free_load(scenario.rig.at(recordings[0].run))
    nominal, own_gap = closed(whole)
    progress("checking the samples")
    faults = sample_findings(recordings, nominal)
    progress("tracking the shaft angle and fitting the parameters of the nominal model")
    runs, before, held = _calibrated(scenario, recordings, nominal, faults)
    other = faults.at_other_level()
    if other is not None:
        progress("testing the other level of the telegraph noise")
        at_other = _calibrated(scenario, recordings, nominal, other)
        if at_other.before.model.cost < before.model.cost:
            faults, (runs, before, held) = other, at_other
    untrue = (
        *faults.untrue,
        *off_ratios(sheets, runs, nominal),
        *off_set_points(recordings, runs, error_max=scenario.operating_point.speed_set_point_error_max),
    )
    before = replace(before, thresholds=thresholds, stated_gap=0.0 if own_gap is None else own_gap.stated)
    return Beginning(
        scenario=scenario, whole=whole, own_gap=own_gap, faults=faults, runs=runs, untrue=untrue, before=before,
        held=held, remarks=(*((unknown,) if thresholds is None else ()), *unvaried(nominal, scenario.uncertainties)),
    )  # fmt: skip


class _Calibrated(NamedTuple):
    runs: tuple[Observed, ...]
    before: Case
    held: tuple[Features, ...]


def _calibrated(
    scenario: Scenario, recordings: Sequence[Recording], nominal: Rig, faults: SampleFindings
) -> _Calibrated:
    """Return the runs along their shafts, and the nominal model calibrated on them."""
    runs = followed(recordings, faults.recordings, nominal)
    return _Calibrated(runs, *opened(scenario, runs, nominal, faults))
