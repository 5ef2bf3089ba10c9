"""What was tried and rejected, and by how many nats of posterior odds it falls short."""

from __future__ import annotations

from typing import Any

from torquerig.inference.addition import Addition
from torquerig.inference.answer.confidence import alternatives, named
from torquerig.inference.answer.numbers import digits
from torquerig.inference.engine import Outcome
from torquerig.inference.search import LEAST_GAIN


def alternatives_of(outcome: Outcome, each: Addition) -> list[dict[str, Any]]:
    """Return the hypotheses that were fitted in the place of an addition, the nearest first."""
    return [
        {"hypothesis": other.label, "mechanism": other.mechanism or None, "nats_behind": digits(gap)}
        for other, gap in alternatives(outcome, each)
    ]


def rejected(outcome: Outcome) -> dict[str, str]:
    """Return for each mechanism that is no finding why it is none, by its best proposal of the last round."""
    found = {each.mechanism for each in named(outcome)}
    answer: dict[str, str] = {}
    for each, gain in sorted(outcome.model.tried, key=lambda one: -one[1]):
        if each.is_named and each.mechanism not in found and each.mechanism not in answer:
            answer[each.mechanism] = _reason(each, gain)
    return dict(sorted(answer.items()))


def _reason(each: Addition, gain: float) -> str:
    if gain == -float("inf"):
        return "tested: a rig with it cannot be evaluated at these runs"
    change = "rises" if gain > 0 else "falls"
    text = f"tested: with {each.label} the log posterior odds {change} by {abs(gain):.1f} nats"
    if gain >= LEAST_GAIN:
        return f"{text} in the local model; the full fit, or held-out data, did not confirm it"
    return f"{text}; a finding needs a rise of {LEAST_GAIN:g}"
