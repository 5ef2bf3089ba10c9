"""Numbers that fit better elsewhere, but not so much better that the stated ones are wrong: they are stated again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.errors import TorquerigError
from torquerig.inference.addition import Addition
from torquerig.inference.answer.confidence import far_numbers
from torquerig.inference.answer.significant import significant
from torquerig.inference.answer.verdict import is_rejected
from torquerig.inference.engine import Outcome
from torquerig.inference.fit import Fit, fitted


def with_stated_numbers(outcome: Outcome) -> Outcome:
    """Return the outcome without its far numbers where the model with the stated ones explains the data.

    That model passes the test of adequacy, and the odds do not reject it: of dozens of numbers one or the other always
    fits a little better elsewhere. Neither the answer nor the written model then has another number than the scenario.
    """
    far = far_numbers(outcome)
    stated = _stated(outcome, far) if far else None
    if stated is None or is_rejected(outcome, stated, far) or significant(outcome, stated)[0]:
        return outcome
    kept = tuple(each for each in outcome.model.additions if not any(each is one for one in far))
    return replace(outcome, model=replace(outcome.model, fit=stated, additions=kept))


def _stated(outcome: Outcome, far: Sequence[Addition]) -> Fit | None:
    """Return the fit with the stated uncertainty of these numbers; None where there cannot be such a rig."""
    fit, own = outcome.model.fit, {knob.name: knob for knob in outcome.nominal.knobs}
    names = {knob.name for each in far for knob in each.knobs}
    start = fit.positions.copy()
    start[[knob.name in names for knob in fit.knobs]] = 0.0
    knobs = [own[knob.name] if knob.name in names else knob for knob in fit.knobs]
    try:
        return fitted(fit.rig, knobs, outcome.data, start=start, gains=fit.gains, off=fit.off, nominal=fit.nominal)
    except (TorquerigError, ValueError):
        return None
