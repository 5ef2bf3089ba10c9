"""Numbers that fit better elsewhere, but not so much better that the stated ones are wrong: they are stated again."""

from __future__ import annotations

from dataclasses import replace

from torquerig.inference.answer.confidence import far_numbers
from torquerig.inference.answer.significant import significant
from torquerig.inference.answer.verdict import is_rejected
from torquerig.inference.engine import Outcome
from torquerig.inference.refitted import refitted


def with_stated_numbers(outcome: Outcome) -> Outcome:
    """Return the outcome without its far numbers where the model with the stated ones explains the data.

    With the numbers held at their stated values it passes the test of adequacy, and the odds do not reject it: of
    dozens of numbers one or the other always fits a little better elsewhere. Neither the answer nor the written model
    then has another number than the scenario.
    """
    far = far_numbers(outcome)
    names = {knob.name for each in far for knob in each.knobs}
    stated = refitted(outcome.model.fit, outcome.data, keeps=lambda knob: knob.name not in names) if far else None
    if stated is None or is_rejected(outcome, stated, far) or significant(outcome, stated)[0]:
        return outcome
    kept = tuple(each for each in outcome.model.additions if not any(each is one for one in far))
    return replace(outcome, model=replace(outcome.model, fit=stated, additions=kept))
