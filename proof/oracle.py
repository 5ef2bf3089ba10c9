"""Oracle: the true mechanisms, and no others, fitted with the code of the diagnosis."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from proof.library import library_of
from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.identifying import identifying
from torquerig.diagnosis.choosing.search import extended, trials
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.engine import Outcome, diagnose
from torquerig.diagnosis.judging.held_out import held_out
from torquerig.diagnosis.judging.untold_runs import of_untold_loads
from torquerig.diagnosis.outcome import Diagnosis, Finding
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario


def oracle(scenario: Scenario, recordings: Sequence[Recording], *, true: Collection[str], seed: int = 0) -> Diagnosis:
    """Return the diagnosis with the ``true`` mechanisms fitted.

    The library is reduced to ``true``. A mechanism below a threshold of the diagnosis (gain, share) is added all the
    same, with its best fit.
    """
    with library_of(true):
        outcome = diagnose(scenario, recordings, seed=seed)
        found = [finding.mechanism for finding in outcome.diagnosis.findings]
        case, forced = outcome.after, list[Finding]()
        for _ in set(true).difference(found):
            best = _best(case, set(true).difference(found))
            if best is None:
                break
            forced.append(_finding(best, case))
            found.append(best.candidate.mechanism)
            case = extended(case, best)
    if not forced:
        return outcome.diagnosis
    untold = of_untold_loads(outcome.held, fitted={run.name for run in outcome.before.runs})
    fit = held_out(outcome.before.nominal, outcome.before.model.rig, _with_faults(case.model.rig, outcome),
                   outcome.held, seed=seed, untold=untold)  # fmt: skip
    return replace(outcome.diagnosis, findings=(*outcome.diagnosis.findings, *forced), fit=fit)


def _best(case: Case, wanted: Collection[str]) -> Trial | None:
    """Return the fit with all parameters free that has the largest gain; None if there is none."""
    fitted = [trial for trial in trials(case).fitted if trial.candidate.mechanism in wanted]
    return max(fitted, key=lambda trial: trial.gain, default=None)


def _finding(trial: Trial, case: Case) -> Finding:
    name = trial.candidate.mechanism
    return Finding(
        mechanism=name, variant=trial.candidate.variant, explanation="True mechanism (oracle).", confidence=1.0,
        parameters=identifying(trial.candidate, trial.model, case), gain=trial.gain,
    )  # fmt: skip


def _with_faults(rig: Rig, outcome: Outcome) -> Rig:
    """Return the rig with the sample faults of the completed rig that the fitted model lacks."""
    fitted = {part.name for part in outcome.after.model.rig.parts}
    for part in outcome.completed.parts:
        if part.name not in fitted:
            rig = rig + part
    return rig
