"""From recordings of one rig and its nominal scenario to a diagnosis: the stations in their order."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import reduce

from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.choosing.identifying import identifying
from torquerig.diagnose.diagnosis import Diagnosis, Finding, HeldOut, Mismatch, UsedRecording, Verdict
from torquerig.diagnose.findings import reasons, run_for_the_rest, searched
from torquerig.diagnose.fitting.calibration import calibrated
from torquerig.diagnose.fitting.knobs import nuisance_knobs, with_free_load
from torquerig.diagnose.free_names import with_free_names
from torquerig.diagnose.judging.by_simulation import left_by_simulation
from torquerig.diagnose.judging.fixed_after_all import looked_at_as_found
from torquerig.diagnose.judging.held_out import held_out
from torquerig.diagnose.judging.leftover import detail_of, mismatches
from torquerig.diagnose.judging.passing import passing
from torquerig.diagnose.judging.whole_fit import LARGEST, misfit_as_a_whole
from torquerig.diagnose.looking.combs import without_comb
from torquerig.diagnose.looking.features import Features, features
from torquerig.diagnose.looking.hum import hum_places
from torquerig.diagnose.looking.lines_left import Strong, known_places, lines_left, strong_lines
from torquerig.diagnose.looking.observed import Observed, observed
from torquerig.diagnose.looking.refilled import refilled
from torquerig.diagnose.looking.shaft_angle import shaft_angles
from torquerig.diagnose.looking.without_tones import less_tones
from torquerig.diagnose.null_table import null_table, without_table
from torquerig.diagnose.rig_under_test import check_recordings, off_set_points
from torquerig.diagnose.sample_findings import SampleFindings, sample_findings
from torquerig.diagnose.sentences import MECHANISMS, explanation
from torquerig.rig.rig import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.reading import Scenario
from torquerig.signals.recording import Recording

Progress = Callable[[str], None]

_BY_TWIN = (
    "a model cannot be simulated with the numbers that the fit gave it, so the held-out misfits are those of linear "
    "twins, and the distribution of values is not compared"
)

_NONE = Strong()
_WORSE = 1.01  # of the held-out misfit before: nothing is named with which it grows
_DETAIL = "what is left is {:.2%} of what was missing, and taken for the detail of what was found"


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """A diagnosis with what a report shows of it: the model before and after, and what was held out.

    Parameters
    ----------
    diagnosis : Diagnosis
    before, after : Case
        With the nominal model calibrated, and with the findings in it.
    completed : Rig
        The rig that a scenario file is written of: fitted, findings and faults of the samples included.
    held : tuple of Features
        Of the stretches that no fit has seen.
    left : tuple of Mismatch
        Where the completed model is still significantly wrong.
    """

    diagnosis: Diagnosis
    before: Case
    after: Case
    completed: Rig
    held: tuple[Features, ...]
    left: tuple[Mismatch, ...]

    @property
    def completes(self) -> bool:
        """Whether the completed rig has parts that the scenario lacks, named or described."""
        return len(self.completed.parts) > len(self.before.nominal.parts) or bool(self.diagnosis.findings)


def diagnose(
    scenario: Scenario, recordings: Sequence[Recording], *, seed: int = 0, progress: Progress = lambda _: None
) -> Outcome:
    """Return where model and recordings differ, which physics was left out, and how much better the model gets.

    Raises
    ------
    InputError, RecordingError
        Where the recordings are of different rigs, contradict the scenario, or are too short to tell anything.
    """
    thresholds, unknown = null_table(scenario), without_table(scenario)
    scenario = with_free_names(scenario, MECHANISMS)
    nominal = with_free_load(scenario.rig.at(recordings[0].run))
    check_recordings(recordings, nominal)
    progress("looking at the samples")
    faults = sample_findings(recordings, nominal)
    progress("following the shaft")
    runs = _runs(recordings, faults.recordings, nominal)
    strong = strong_lines(runs, nominal)
    if strong.orders or strong.tones:
        runs = _runs(recordings, faults.recordings, nominal, strong)
    untrue = [*faults.untrue, *off_set_points(recordings, runs)]
    progress("fitting the nominal model's own numbers")
    before, held = _opened(scenario, runs, nominal, faults)
    before = replace(before, thresholds=thresholds)
    fitted = {run.name for run in before.runs}
    sought = searched(before, [each for each in held if each.observed.name in fitted], progress)
    progress("predicting what no fit has seen")
    fitted_nominal = reduce(_without, faults.candidates, before.model.rig)

    def foretold(case: Case) -> tuple[Case, tuple[Features, ...], Rig, HeldOut]:
        after, unseen = looked_at_as_found(case, held)
        completed = _completed(after, faults)
        return after, unseen, completed, held_out(nominal, fitted_nominal, completed, unseen, seed=seed)

    after, unseen, completed, fit = foretold(sought.case)
    if (sought.findings or sought.descriptions) and fit.after > _WORSE * fit.before:
        sought = sought.all_withdrawn(before)
        after, unseen, completed, fit = foretold(before)
    found_more = bool(sought.findings or faults.candidates or sought.descriptions)
    found = [*_fault_findings(faults, after, fit), *sought.findings]
    came_and_went = passing(after, completed)
    left = (*left_by_simulation(after, mismatches(after)), *came_and_went)
    detail = detail_of(before, after, left)
    left = left if detail is None else ()
    if not (left or found or sought.descriptions) and fit.after > LARGEST:
        left = (misfit_as_a_whole(after),)
    verdict = _verdict(found, left, faults, described=bool(sought.descriptions))
    diagnosis = Diagnosis(
        verdict=verdict,
        mismatch=(
            *((*mismatches(before), *came_and_went) if found_more else left),
            *(mismatch for _, mismatch in untrue),
        ),
        findings=tuple(found),
        fit=fit,
        recordings=tuple(_used(run) for run in runs),
        remarks=(
            *(sentence for sentence, _ in untrue),
            *(f"no mechanism of the library explains {what}" for what in sought.descriptions),
            *([_BY_TWIN] if fit.by_twin else []),
            *([] if detail is None else [_DETAIL.format(detail)]),
            *([unknown] if thresholds is None else []),
        ),
        set_aside=reasons(before, sought, found),
        next_experiment=run_for_the_rest(sought) if verdict == "unexplained" else None,
    )
    return Outcome(diagnosis=diagnosis, before=before, after=after, completed=completed, held=unseen, left=left)


def _runs(
    recordings: Sequence[Recording], mended: Sequence[Recording], rig: Rig, strong: Strong = _NONE
) -> tuple[Observed, ...]:
    """Return the runs with the torque of the mended recordings, and their samples as they were recorded.

    Their angle is followed by the ``strong`` orders as well, and beside the strong tones.
    """
    angles, factor = shaft_angles([_less(each, strong.tones) for each in mended], rig, also=strong.orders)
    ratio = kinematics_of(rig).ratio
    runs = [observed(each, angle, ratio=ratio, factor=factor) for each, angle in zip(mended, angles, strict=True)]
    return tuple(replace(run, recording=replace(raw, run=run.run)) for run, raw in zip(runs, recordings, strict=True))


def _less(recording: Recording, tones: Sequence[float]) -> Recording:
    name = recording.torque_name()
    values = less_tones(recording.channels[name].values, recording.sample_rate, tones)
    return recording.with_values(name, values) if tones else recording


def _opened(
    scenario: Scenario, runs: tuple[Observed, ...], nominal: Rig, faults: SampleFindings
) -> tuple[Case, tuple[Features, ...]]:
    """Return the case with the nominal model calibrated, and the held-out features."""
    whole = _unclipped(runs, faults)
    known = known_places(whole, nominal)
    left = without_comb(lines_left(whole, known, rig=nominal))
    unknown = [peak.place for peak in left]
    places = [*known, *unknown, *hum_places(left)]
    runs = tuple(refilled(run, lost, places) for run, lost in zip(runs, faults.lost, strict=True))
    fitted = _unclipped(runs, faults)
    seen = tuple(features(run, places, unknown=unknown) for run in fitted)
    held = tuple(features(run, places, held=True, unknown=unknown) for run in runs)
    occupancies = [run.run.occupancy_percent or 0.0 for run in fitted]
    knobs = nuisance_knobs(nominal, scenario.uncertainties, occupancies=occupancies)
    rig = _with(nominal, [c for c in faults.candidates if c.mechanism == "quantization"])
    apart = calibrated(rig, [each.without(unknown) for each in seen], knobs)
    model = calibrated(rig, seen, knobs, start=apart.positions, jacobian=apart.jacobian, near=False)
    return Case(nominal=rig, runs=fitted, seen=seen, model=model, left=left, apart=apart.positions), held


def _unclipped(runs: tuple[Observed, ...], faults: SampleFindings) -> tuple[Observed, ...]:
    """Return the runs that fits may use: those that are not clipped, all where all are."""
    return tuple(run for run in runs if run.name not in faults.clipped) or runs


def _fault_findings(faults: SampleFindings, case: Case, fit: HeldOut) -> list[Finding]:
    answer = []
    for candidate in faults.candidates:
        model = replace(case.model, rig=candidate.added_to(_without(case.model.rig, candidate)))
        parameters = identifying(candidate, model, case)
        said = explanation(candidate.mechanism, parameters, share=1.0, rivals=(), gain=0.0)
        finding = Finding(
            mechanism=candidate.mechanism, variant="", explanation=said, confidence=0.98, parameters=parameters,
            gain=fit.before - fit.after,
        )  # fmt: skip
        answer.append(finding)
    return answer


def _verdict(
    findings: Sequence[Finding], left: Sequence[Mismatch], faults: SampleFindings, *, described: bool
) -> Verdict:
    if left or faults.unnamed or faults.untrue or described:
        return "unexplained"
    return "missing_physics" if findings else "adequate"


def _completed(case: Case, faults: SampleFindings) -> Rig:
    return _with(case.model.rig, [c for c in faults.candidates if c.mechanism != "quantization"])


def _with(rig: Rig, candidates: Sequence[Candidate]) -> Rig:
    for candidate in candidates:
        rig = candidate.added_to(rig)
    return rig


def _without(rig: Rig, candidate: Candidate) -> Rig:
    present = {part.name for part in rig.parts}
    for part in candidate.parts:
        rig = rig.without(part.name) if part.name in present else rig
    return rig


def _used(run: Observed) -> UsedRecording:
    speed = run.run.speed_rpm if not run.steady else run.mean_speed * 30 / 3.141592653589793
    return UsedRecording(file=run.name, speed_rpm=speed or 0.0, used_for="split")
