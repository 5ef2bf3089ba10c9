"""A gap that was found first, its width told again beside a further effect: what else is missing bends both."""

from __future__ import annotations

from dataclasses import replace

from torquerig.diagnose.case import Case
from torquerig.diagnose.choosing.gap_trial import fitted_gap, simulated_model
from torquerig.diagnose.choosing.opened_gap import GAP
from torquerig.diagnose.choosing.trial import PER_KNOB, Trial
from torquerig.errors import SimulationError


def told_again(case: Case, trial: Trial) -> Trial | None:
    """Return the trial fitted around a gap of a new width; None where that comes no nearer.

    Parameters
    ----------
    case : Case
        With a gap in its model.
    trial : Trial
        Of an effect beside it.
    """
    others = tuple(candidate for candidate in case.accepted if candidate.mechanism != GAP)
    if len(others) == len(case.accepted):
        return None
    bare = replace(case, accepted=(*others, trial.candidate), model=replace(trial.model, corrections=()))
    try:
        found = fitted_gap(bare, bare.nominal_with_accepted())
    except SimulationError:
        return None
    if found is None or found.model.cost >= trial.model.cost:
        return None
    gain = case.model.cost - found.model.cost - PER_KNOB * len(trial.candidate.knobs) - trial.candidate.price
    return replace(trial, model=simulated_model(found.candidate, found.model), gain=gain, gap=found.candidate)
