"""A gap, its width told again beside a further effect or without one: what else is missing bends both."""

from __future__ import annotations

from dataclasses import replace

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.gap_fits import FittedGap
from torquerig.diagnosis.choosing.gap_trial import fitted_gap, simulated_model
from torquerig.diagnosis.choosing.opened_gap import GAP
from torquerig.diagnosis.choosing.trial import PER_KNOB, Trial
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
    if not case.has(GAP):
        return None
    found = _told(replace(case, accepted=(*case.accepted, trial.candidate), model=trial.model))
    if found is None or found.model.cost >= trial.model.cost:
        return None
    gain = case.model.cost - found.model.cost - PER_KNOB * len(trial.candidate.knobs) - trial.candidate.price
    return replace(trial, model=simulated_model(found.candidate, found.model), gain=gain, gap=found.candidate)


def gap_anew(case: Case) -> Case | None:
    """Return the case with its gap told again and simulated again beside all else; None where nothing tells one.

    What a gap adds to lines was simulated with what the model had then: of an effect that is gone it kept the lines.
    """
    found = _told(case)
    if found is None:
        return None
    accepted = tuple(found.candidate if each.mechanism == GAP else each for each in case.accepted)
    return replace(case, accepted=accepted, model=simulated_model(found.candidate, found.model))


def _told(case: Case) -> FittedGap | None:
    """Return the gap beside all else that the case has; None where nothing tells one, or it can't be simulated."""
    others = tuple(candidate for candidate in case.accepted if candidate.mechanism != GAP)
    bare = replace(case, accepted=others, model=replace(case.model, corrections=()))
    try:
        return fitted_gap(bare, bare.nominal_with_accepted())
    except SimulationError:
        return None
