"""The verdict: adequate, missing physics, unexplained or a fault of the set-up."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.inference.addition import Addition
from torquerig.inference.answer.confidence import far_numbers, named, nameless, unsure_numbers
from torquerig.inference.answer.owned import owned
from torquerig.inference.answer.significant import significant
from torquerig.inference.answer.sizes import relevance, size, without
from torquerig.inference.engine import Outcome
from torquerig.inference.prediction.expected_run import expected_run


def verdict(outcome: Outcome) -> str:
    """Return the contract's word for what was found."""
    if not outcome.judged:
        return "missing_physics"
    large = [each for each in nameless(outcome) if not is_minor(outcome, each)]
    if unsure_numbers(outcome) or not explains(outcome, ()) or (large and not explains(outcome, large)):
        return "unexplained"
    far = far_numbers(outcome)
    if named(outcome) or any(owned(outcome, each) for each in far):
        return "missing_physics"
    return "setup_error" if outcome.setup or far else "adequate"


def is_minor(outcome: Outcome, each: Addition) -> bool:
    """Return whether a nameless effect is too small to change the verdict."""
    return size(outcome, each) < relevance(outcome)


def explains(outcome: Outcome, less: Sequence[Addition]) -> bool:
    """Return whether the completed model without some additions passes the test of adequacy."""
    fit, rig = outcome.model.fit, without(outcome.completed, less)
    if less:
        fit = replace(fit, expected=tuple(expected_run(rig, seen) for seen in outcome.data.seen))
    return not significant(outcome, fit)
