"""Which mechanisms were set aside, before a full fit or after it, each with its one reason."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig import mechanisms
from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.explained import explained_share
from torquerig.diagnosis.choosing.gap_trial import gap_is_possible
from torquerig.diagnosis.choosing.opened_gap import GAP, flanks_may_part
from torquerig.diagnosis.choosing.search import Tried, excess
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.hypotheses import CLASSES
from torquerig.diagnosis.hypotheses.reasons import why_none
from torquerig.scenario.kinematics import gears_to_sensor

SAMPLE_FAULTS = {
    "clipping": ("Clipping", "no samples stay at a limit"),
    "quantization": ("Quantization", "the code step is that of the stated converter"),
    "signal_dropout": ("SignalDropout", "no dropouts in the samples"),
}
_ALL_CLASSES = {**CLASSES, **{name: of for name, (of, _) in SAMPLE_FAULTS.items()}, GAP: "Backlash"}
CONTRACT = set(_ALL_CLASSES)
_NOT_THERE = "not in the library"
_NEVER_PART = "the torque is near zero in no recording, so no contact loss is possible"
_SLIPPING = (
    "stick-slip causes impacts without load like those of contact loss, and these recordings do not distinguish them"
)


def set_aside(case: Case, tried: Tried, *, known: Sequence[str]) -> dict[str, str]:
    """Return a reason for every mechanism of the contract that is not told elsewhere.

    Parameters
    ----------
    case : Case
        The calibrated nominal model.
    tried : Tried
        What was fitted to it.
    known : sequence of str
        Mechanisms that the diagnosis names, and their rivals.
    """
    best_last = reversed(tried.fitted)
    fitted = {trial.candidate.mechanism: _fitted(case, trial) for trial in best_last}
    answer = {name: reason for name, reason in fitted.items() if name in CONTRACT and name not in known}
    told = {*known, *answer}
    for name, class_name in CLASSES.items():
        if name not in told:
            answer[name] = _reason(name, class_name, case, tried.screened)
    for name, (class_name, reason) in SAMPLE_FAULTS.items():
        if name not in told:
            answer[name] = reason if hasattr(mechanisms, class_name) else _NOT_THERE
    if GAP not in told:
        answer[GAP] = _no_gap(case, tried)
    return {name: _beside_own(name, reason, case) for name, reason in sorted(answer.items())}


def _beside_own(name: str, reason: str, case: Case) -> str:
    """Say first that the scenario has the mechanism, where it has: the reason is then why it has no second one."""
    return f"the scenario already contains it; a second one: {reason}" if case.nominal.of_kind(name) else reason


def _fitted(case: Case, trial: Trial) -> str:
    """Say how little of the misfit went with an effect that was fitted."""
    if excess(case) <= 0:
        return "fitted with all parameters: without it, the residual is within random error"
    share = explained_share(case.model.misfits, trial.model.misfits, beside=trial.beside)
    of_all = min(max(trial.gain, 0.0) / excess(case), 1.0)
    return (
        f"fitted with all parameters: it removes {of_all:.0%} of the significant residual, and {max(share, 0.0):.0%} "
        "where it acts"
    )


def _reason(name: str, class_name: str, case: Case, screened: Sequence[Trial]) -> str:
    if not hasattr(mechanisms, class_name):
        return _NOT_THERE
    own = next((trial for trial in screened if trial.candidate.mechanism == name), None)
    if own is None:
        return why_none(name, case)
    best = screened[0]
    name = best.candidate.mechanism.replace("_", " ")
    if own.gain <= 0:
        return "tested: chi-square falls by less than the penalty for its parameters"
    return f"tested: chi-square falls by {own.gain / best.gain:.1%} of the fall with {name}"


def _no_gap(case: Case, tried: Tried) -> str:
    if not hasattr(mechanisms, "Backlash"):
        return _NOT_THERE
    if not gears_to_sensor(case.nominal):
        return "the rig has no gear"
    if not any(flanks_may_part(features) for features in case.seen):
        return _SLIPPING if any(run.slipping for run in case.runs) else _NEVER_PART
    if tried.gap_failed:
        return "tested: the model with backlash cannot be simulated with its fitted parameters"
    if gap_is_possible(case):
        return "the residual is explained without backlash"
    return "no contact loss: the torque is never quiet near zero and then ends in an impact"
