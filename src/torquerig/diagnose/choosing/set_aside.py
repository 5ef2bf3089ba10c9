"""Which mechanisms were set aside without a full fit, each with its one reason."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig import mechanisms
from torquerig.diagnose.case import Case
from torquerig.diagnose.choosing.gap_trial import flanks_may_part, gap_is_possible
from torquerig.diagnose.choosing.search import Trial, Tried
from torquerig.diagnose.hypotheses import CLASSES
from torquerig.diagnose.hypotheses.reasons import why_none
from torquerig.scenario.kinematics import gears_to_sensor

SAMPLE_FAULTS = {
    "clipping": ("Clipping", "no reading stays at a flat top"),
    "quantization": ("Quantization", "codes stand as close as the converter's"),
    "signal_dropout": ("SignalDropout", "no moments without signal"),
}
_NOT_THERE = "not in the library"


def set_aside(case: Case, tried: Tried, *, found: Sequence[str]) -> dict[str, str]:
    """Return a reason for every mechanism of the contract that is neither found nor was fitted with all numbers.

    Parameters
    ----------
    case : Case
        The calibrated nominal model.
    tried : Tried
        What was fitted to it.
    found : sequence of str
        Mechanisms that the diagnosis names.
    """
    known = {*(trial.candidate.mechanism for trial in tried.fitted), *found}
    answer = {}
    for name, class_name in CLASSES.items():
        if name not in known:
            answer[name] = _reason(name, class_name, case, tried.screened)
    for name, (class_name, reason) in SAMPLE_FAULTS.items():
        if name not in known:
            answer[name] = reason if hasattr(mechanisms, class_name) else _NOT_THERE
    if "backlash" not in known:
        answer["backlash"] = _no_gap(case, tried)
    return dict(sorted(answer.items()))


def _reason(name: str, class_name: str, case: Case, screened: Sequence[Trial]) -> str:
    if not hasattr(mechanisms, class_name):
        return _NOT_THERE
    own = next((trial for trial in screened if trial.candidate.mechanism == name), None)
    if own is None:
        return why_none(name, case)
    best = screened[0]
    name = best.candidate.mechanism.replace("_", " ")
    if own.gain <= 0:
        return "tried, and the misfit falls by less than its numbers cost"
    return f"tried, and the misfit falls by {own.gain / best.gain:.1%} of what {name} takes away"


def _no_gap(case: Case, tried: Tried) -> str:
    if not hasattr(mechanisms, "Backlash"):
        return _NOT_THERE
    if not gears_to_sensor(case.nominal):
        return "the rig has no gear"
    if not any(flanks_may_part(features) for features in case.seen):
        return "the torque comes near zero in no run, so flanks never part"
    if tried.gap_failed:
        return "tried, and the numbers fitted around a gap cannot be simulated"
    if gap_is_possible(case):
        return "what is left was explained without a gap"
    return "the torque never stays quietly near zero and ends that in a blow, as flanks that part and meet do"
