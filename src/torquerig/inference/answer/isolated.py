"""What an answer says of isolability: the smallest visible sizes, and the run that separates what is alike."""

from __future__ import annotations

from typing import Any

from torquerig.inference.addition import Addition
from torquerig.inference.answer.confidence import ALIKE, alternatives, nameless
from torquerig.inference.answer.sizes import is_minor, size
from torquerig.inference.engine import Outcome
from torquerig.inference.isolability.limits import as_limit, smallest_of_each
from torquerig.inference.isolability.probes import hypotheses, probed
from torquerig.inference.isolability.separating import exchanged, separating_run
from torquerig.inference.isolability.signatures import Projection


def upper_limits(outcome: Outcome) -> list[dict[str, Any]]:
    """Return for each mechanism the smallest size that the recordings would have shown, in 95 % of such recordings."""
    known = outcome.data.seen[0].places
    context, places = probed(outcome.model.fit, outcome.runs, known)
    return [as_limit(each) for each in smallest_of_each(Projection(context), hypotheses(context, places))]


def next_experiment(outcome: Outcome, each: Addition) -> str | None:
    """Return which further run separates a finding from the nearest effect that it may be instead, or None."""
    near = (one for one, gap in alternatives(outcome, each) if gap < ALIKE and one.parts)
    other = next((one for one in near if one.mechanism != each.mechanism), None)
    if other is None:
        return None
    return _separating(outcome, each, other, names=(each.mechanism, other.mechanism or other.label))


def next_experiment_for_nameless(outcome: Outcome) -> str | None:
    """Return which further run separates the largest nameless effect from the nearest hypothesis, or None.

    None too where no hypothesis is near, or all nameless effects are minor.
    """
    large = [each for each in nameless(outcome) if not is_minor(outcome, each)]
    if not large:
        return None
    each = max(large, key=lambda one: size(outcome, one))
    other = next((one for one, gap in alternatives(outcome, each) if gap < ALIKE), None)
    return None if other is None else _separating(outcome, each, other, names=(each.label, other.label))


def _separating(outcome: Outcome, each: Addition, other: Addition, *, names: tuple[str, str]) -> str | None:
    fit = outcome.model.fit
    instead = exchanged(fit, outcome.data, less=each, more=other)
    if instead is None:
        return None
    return separating_run(outcome.completed, instead, outcome.data.seen, fit, names=names)
