"""The verdict: adequate, missing physics, unexplained or a fault of the set-up."""

from __future__ import annotations

from collections.abc import Sequence
from math import log

from torquerig.inference.addition import Addition
from torquerig.inference.adequacy import LEVEL_OF_TEST
from torquerig.inference.answer.confidence import TEMPER, far_numbers, named, nameless, unsure_numbers
from torquerig.inference.answer.owned import owned
from torquerig.inference.answer.significant import significant
from torquerig.inference.answer.sizes import is_minor
from torquerig.inference.engine import Outcome
from torquerig.inference.fit import Fit
from torquerig.inference.held_out import held_out_density
from torquerig.inference.own_features import without_parts
from torquerig.inference.refitted import refitted


def verdict(outcome: Outcome) -> str:
    """Return the contract's word for what was found."""
    if outcome.untrue:
        return "unexplained"
    if not outcome.judged:
        return "missing_physics"
    large = [each for each in nameless(outcome) if not is_minor(outcome, each)]
    if unsure_numbers(outcome) or not explains(outcome, ()):
        return "unexplained"
    if large and (not explains(outcome, large) or are_evident(outcome, large)):
        return "unexplained"
    far = far_numbers(outcome)
    if named(outcome) or any(owned(outcome, each) for each in far):
        return "missing_physics"
    return "setup_error" if outcome.setup or far else "adequate"


def explains(outcome: Outcome, less: Sequence[Addition]) -> bool:
    """Return whether the completed model without some additions passes the test of adequacy."""
    return not significant(
        outcome, without_parts(outcome.model.fit, outcome.data, less) if less else outcome.model.fit
    )[0]


def are_evident(outcome: Outcome, each: Sequence[Addition]) -> bool:
    """Return whether the posterior odds of some additions reject the model without them at the level of the test.

    Under a true model a likelihood ratio exceeds ``1 / p`` with a probability of p at most, whatever it is compared
    with (Markov's inequality; Wasserman, Ramdas & Balakrishnan 2020, PNAS 117(29)): all that residuals show at the
    place of an effect counts, where the largest one or their sum says little. Prior odds stand for the places that were
    searched. As in ``confidence``, ``TEMPER`` nats count for one.
    """
    fit, names = outcome.model.fit, frozenset(part.name for one in each for part in one.parts)
    less = refitted(fit, outcome.data, keeps=lambda knob: knob.part not in names, without=names)
    return less is not None and is_rejected(outcome, less, each)


def is_rejected(outcome: Outcome, less: Fit, each: Sequence[Addition]) -> bool:
    """Return whether the odds of some additions reject a fit without them."""
    fit = outcome.model.fit
    odds = fit.log_evidence - less.log_evidence + sum(one.log_odds for one in each)
    held_out = held_out_density(fit, outcome.held) - held_out_density(less, outcome.held)
    return odds + held_out > TEMPER * log(1 / LEVEL_OF_TEST)
