"""Numbers that fit better elsewhere, but not so much better that the stated ones are wrong: they are stated again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.inference.addition import Addition
from torquerig.inference.answer.confidence import far_numbers
from torquerig.inference.answer.numbers import estimate
from torquerig.inference.answer.significant import significant
from torquerig.inference.answer.verdict import is_rejected
from torquerig.inference.engine import Outcome
from torquerig.inference.fit import Fit
from torquerig.inference.refitted import refitted


def with_stated_numbers(outcome: Outcome) -> Outcome:
    """Return the outcome without its far numbers where the model with the stated ones explains the data.

    With the numbers held at their stated values it passes the test of adequacy, and the odds do not reject it: of
    dozens of numbers one or the other always fits a little better elsewhere. Neither the answer nor the written model
    then has another number than the scenario. A number whose 95 % interval holds the stated value is never far.
    """
    same = [each for each in far_numbers(outcome) if _holds_stated(outcome.model.fit, each)]
    outcome = _without(outcome, same, _stated(outcome, same))
    far = far_numbers(outcome)
    stated = _stated(outcome, far)
    if stated is None or is_rejected(outcome, stated, far) or significant(outcome, stated)[0]:
        return outcome
    return _without(outcome, far, stated)


def _holds_stated(fit: Fit, each: Addition) -> bool:
    knob = each.knobs[0]
    low, high = estimate(fit, [one.name for one in fit.knobs].index(knob.name), "")["ci95"]
    return bool(low <= knob.value(fit.nominal) <= high)


def _stated(outcome: Outcome, far: Sequence[Addition]) -> Fit | None:
    """Return the fit with some numbers held at their stated values; None where there is none to be held."""
    names = {knob.name for each in far for knob in each.knobs}
    return refitted(outcome.model.fit, outcome.data, keeps=lambda knob: knob.name not in names) if far else None


def _without(outcome: Outcome, far: Sequence[Addition], stated: Fit | None) -> Outcome:
    if stated is None:
        return outcome
    kept = tuple(each for each in outcome.model.additions if not any(each is one for one in far))
    return replace(outcome, model=replace(outcome.model, fit=stated, additions=kept))
