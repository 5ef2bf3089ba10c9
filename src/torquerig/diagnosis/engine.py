"""From recordings of one rig and its nominal scenario to a diagnosis: the stations in their order."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from torquerig.diagnosis.beginning import begun
from torquerig.diagnosis.believed import believed
from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.opened_gap import GAP
from torquerig.diagnosis.findings import faults_found, reasons, run_for_the_rest, searched
from torquerig.diagnosis.judging.last_questions import last_question
from torquerig.diagnosis.judging.whole_fit import misfit_as_a_whole
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.outcome import Diagnosis, Finding, UsedRecording, Verdict
from torquerig.diagnosis.sample_findings import SampleFindings
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

Progress = Callable[[str], None]

_BY_TWIN = (
    "A model cannot be simulated with its fitted parameters. The held-out residuals are therefore those of its "
    "linearisation, without the distribution of values."
)

_FILLED = (
    "Dropouts are interpolated in the recordings and omitted from the simulations. They do not change the held-out "
    "residual."
)

_DETAIL = "The remaining residual is {:.2%} of the initial one. It is attributed to details of the findings."


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
    own_gap, faults, before = start.own_gap, start.faults, start.before
    all_found = searched(before, start.of_fitted_runs(), progress)
    progress("predicting the held-out data")
    told = believed(start, all_found, seed=seed)
    sought, after, fit, left = told.sought, told.after, told.fit, told.left
    gap_told = own_gap is not None and after.has(GAP)
    named = [each for each in sought.findings if not (gap_told and each.mechanism == GAP)]
    found_more = bool(named or faults.candidates or sought.descriptions)
    found = [*faults_found(faults, after, gain=fit.before - fit.after), *named]
    as_a_whole, asked = tuple[Mismatch, ...](), tuple[tuple[str, Mismatch], ...]()
    if not (left or named or sought.descriptions):
        coarse = any(each.mechanism == "quantization" for each in faults.candidates)
        whole_fit = misfit_as_a_whole(after, told.held, held_out=fit.after, coarse=coarse)
        asked = () if whole_fit else _asked_last(after, faults)
        left = as_a_whole = whole_fit or tuple(mismatch for _, mismatch in asked)
    verdict = _verdict(found, left, faults, described=bool(sought.descriptions))
    diagnosis = Diagnosis(
        verdict=verdict,
        mismatch=(
            *((*told.missed, *told.changing_spectra, *as_a_whole) if found_more else left),
            *(mismatch for _, mismatch in start.untrue),
        ),
        findings=tuple(found),
        fit=fit,
        recordings=tuple(_used(run) for run in start.runs),
        remarks=(
            *(sentence for sentence, _ in start.untrue),
            *(f"No mechanism of the library explains {what}." for what in sought.descriptions),
            *([own_gap.sentence(after.model.rig)] if own_gap is not None and gap_told else []),
            *(sentence for sentence, _ in (*told.changes, *asked) if sentence),
            *([_FILLED] if any(each.mechanism == "signal_dropout" for each in faults.candidates) else []),
            *([_BY_TWIN] if fit.by_twin else []),
            *([] if told.detail is None else [_DETAIL.format(told.detail)]),
            *start.remarks,
        ),
        set_aside=reasons(before, sought, found, why=told.why),
        next_experiment=run_for_the_rest(sought) if verdict == "unexplained" else None,
    )
    return Outcome(diagnosis=diagnosis, before=before, after=after, completed=told.completed, held=told.held, left=left)


def _verdict(
    findings: Sequence[Finding], left: Sequence[Mismatch], faults: SampleFindings, *, described: bool
) -> Verdict:
    if left or faults.unnamed or faults.untrue or described:
        return "unexplained"
    return "missing_physics" if findings else "adequate"


def _asked_last(case: Case, faults: SampleFindings) -> tuple[tuple[str, Mismatch], ...]:
    """Return what the last questions find, where no fault of samples and no gap is there, which make such things."""
    if faults.candidates or faults.unnamed or case.has(GAP):
        return ()
    told = last_question(case)
    return () if told is None else (told,)


def _used(run: Observed) -> UsedRecording:
    speed = run.run.speed_rpm if not run.steady else run.mean_speed * 30 / 3.141592653589793
    return UsedRecording(file=run.name, speed_rpm=speed or 0.0, used_for="split")
