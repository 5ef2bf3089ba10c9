"""From recordings of one rig and its nominal scenario to a diagnosis: the stations in their order."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from torquerig.diagnose.beginning import begun
from torquerig.diagnose.case import Case
from torquerig.diagnose.diagnosis import Diagnosis, Finding, HeldOut, Mismatch, UsedRecording, Verdict
from torquerig.diagnose.findings import faults_found, reasons, run_for_the_rest, searched
from torquerig.diagnose.judging.by_simulation import left_by_simulation
from torquerig.diagnose.judging.changing import changing
from torquerig.diagnose.judging.fixed_after_all import looked_at_as_found
from torquerig.diagnose.judging.held_out import held_out, of_untold_loads
from torquerig.diagnose.judging.last_questions import last_question
from torquerig.diagnose.judging.leftover import detail_of, mismatches
from torquerig.diagnose.judging.passing import passing
from torquerig.diagnose.judging.whole_fit import misfit_as_a_whole
from torquerig.diagnose.judging.withdrawn import (
    COMES_AND_GOES,
    LEAVES_A_REST,
    ONE_OF_MANY,
    STILL_WRONG,
    TOO_MANY,
    why_withdrawn,
)
from torquerig.diagnose.looking.features import Features
from torquerig.diagnose.looking.observed import Observed
from torquerig.diagnose.own_gap import MECHANISM
from torquerig.diagnose.sample_findings import SampleFindings
from torquerig.rig.rig import Rig
from torquerig.scenario.reading import Scenario
from torquerig.signals.recording import Recording

Progress = Callable[[str], None]

_BY_TWIN = (
    "a model cannot be simulated with the numbers that the fit gave it, so the held-out misfits are those of linear "
    "twins, and the distribution of values is not compared"
)

_FILLED = (
    "moments without signal are filled in the recordings and left out of the simulations beside them, so the held-out "
    "misfit is the same with them and without"
)

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
    scenario: Scenario, recordings: Sequence[Recording], *, others: Sequence[Scenario] = (), seed: int = 0,
    progress: Progress = lambda _: None,
) -> Outcome:  # fmt: skip
    """Return where model and recordings differ, which physics was left out, and how much better the model gets.

    Parameters
    ----------
    scenario : Scenario
    recordings : sequence of Recording
        Runs of one rig.
    others : sequence of Scenario
        The scenario as it may be read too, where a catalog leaves whole numbers open (``scenario.readings``).
    seed : int
    progress : callable

    Raises
    ------
    InputError, RecordingError
        Where the recordings are of different rigs, contradict the scenario, or are too short to tell anything.
    """
    start = begun(scenario, others, recordings, progress)
    whole, own_gap, faults, before, held = start.whole, start.own_gap, start.faults, start.before, start.held
    fitted = {run.name for run in before.runs}
    used = [each for each in held if each.observed.name in fitted]
    untold = of_untold_loads(held, fitted=fitted)
    all_found = searched(before, used, progress)
    progress("predicting what no fit has seen")
    fitted_nominal = before.model.rig
    for candidate in faults.candidates:
        fitted_nominal = candidate.removed_from(fitted_nominal)

    def foretold(case: Case) -> tuple[Case, tuple[Features, ...], Rig, HeldOut]:
        after, unseen = looked_at_as_found(case, held)
        completed, fitted = _completed(after, faults), fitted_nominal
        if own_gap is not None:
            width = own_gap.told(completed)
            completed, fitted = own_gap.reopened(completed), own_gap.reopened(fitted, width=width)
        return after, unseen, completed, held_out(whole, fitted, completed, unseen, seed=seed, untold=untold)

    changes = changing([run for run in before.runs if run.name not in faults.clipped])
    moved = [mismatch for _, mismatch in changes]
    missed = mismatches(before)
    flown = any(_of_flights(mismatch) and len(mismatch.recordings) > 1 for mismatch in missed)
    why = ""
    for sought in all_found.in_turn(before, used):
        if sought.numbers_held and (
            why in (COMES_AND_GOES, TOO_MANY, STILL_WRONG, ONE_OF_MANY)
            or (why == LEAVES_A_REST and not sought.all_lines)
        ):
            continue  # numbers that stand still explain no more of it; with a line, others may have moved
        after, unseen, completed, fit = foretold(sought.case)
        came_and_went = passing(after, completed)
        left = (*left_by_simulation(after, mismatches(after)), *came_and_went, *moved)
        detail = detail_of(before, after, left)
        left = left if detail is None else ()
        resembled = any(each.trial.candidate.resembled for each in sought.accepted)
        effects = len(sought.accepted)
        drifts = bool(moved) and after.has("sensor_drift")
        refused = why_withdrawn(
            fit, left, effects=effects, resembled=resembled, passing=came_and_went, drifts_in_all=drifts,
            samples_too=bool(start.untrue or faults.untrue), again=why == LEAVES_A_REST,
            turning_lines=sought.turning_lines,
            flights_told=flown and after.has(MECHANISM) and not any(_of_flights(each) for each in left),
        )  # fmt: skip
        if not (sought.accepted and refused):
            break
        why = refused
    gap_told = own_gap is not None and after.has(MECHANISM)
    named = [each for each in sought.findings if not (gap_told and each.mechanism == MECHANISM)]
    found_more = bool(named or faults.candidates or sought.descriptions)
    found = [*faults_found(faults, after, gain=fit.before - fit.after), *named]
    as_a_whole, asked = tuple[Mismatch, ...](), tuple[tuple[str, Mismatch], ...]()
    if not (left or named or sought.descriptions):
        coarse = any(each.mechanism == "quantization" for each in faults.candidates)
        whole_fit = misfit_as_a_whole(after, unseen, held_out=fit.after, coarse=coarse)
        asked = () if whole_fit else _asked_last(after, faults)
        left = as_a_whole = whole_fit or tuple(mismatch for _, mismatch in asked)
    verdict = _verdict(found, left, faults, described=bool(sought.descriptions))
    diagnosis = Diagnosis(
        verdict=verdict,
        mismatch=(
            *((*missed, *came_and_went, *moved, *as_a_whole) if found_more else left),
            *(mismatch for _, mismatch in start.untrue),
        ),
        findings=tuple(found),
        fit=fit,
        recordings=tuple(_used(run) for run in start.runs),
        remarks=(
            *(sentence for sentence, _ in start.untrue),
            *(f"no mechanism of the library explains {what}" for what in sought.descriptions),
            *([own_gap.sentence(after.model.rig)] if own_gap is not None and gap_told else []),
            *(sentence for sentence, _ in (*changes, *asked) if sentence),
            *([_FILLED] if any(each.mechanism == "signal_dropout" for each in faults.candidates) else []),
            *([_BY_TWIN] if fit.by_twin else []),
            *([] if detail is None else [_DETAIL.format(detail)]),
            *start.remarks,
        ),
        set_aside=reasons(before, sought, found, why=why),
        next_experiment=run_for_the_rest(sought) if verdict == "unexplained" else None,
    )
    return Outcome(diagnosis=diagnosis, before=before, after=after, completed=completed, held=unseen, left=left)


def _verdict(
    findings: Sequence[Finding], left: Sequence[Mismatch], faults: SampleFindings, *, described: bool
) -> Verdict:
    if left or faults.unnamed or faults.untrue or described:
        return "unexplained"
    return "missing_physics" if findings else "adequate"


def _of_flights(mismatch: Mismatch) -> bool:
    return mismatch.domain == "distribution" and mismatch.axis == "V"


def _asked_last(case: Case, faults: SampleFindings) -> tuple[tuple[str, Mismatch], ...]:
    """Return what the last questions find, where no fault of samples and no gap is there, which make such things."""
    if faults.candidates or faults.unnamed or case.has(MECHANISM):
        return ()
    told = last_question(case)
    return () if told is None else (told,)


def _completed(case: Case, faults: SampleFindings) -> Rig:
    rig = case.model.rig
    for candidate in faults.candidates:
        rig = rig if candidate.mechanism == "quantization" else candidate.added_to(rig)
    return rig


def _used(run: Observed) -> UsedRecording:
    speed = run.run.speed_rpm if not run.steady else run.mean_speed * 30 / 3.141592653589793
    return UsedRecording(file=run.name, speed_rpm=speed or 0.0, used_for="split")
