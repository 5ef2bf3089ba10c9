"""What an answer says of isolability: the smallest visible sizes, and the run that separates what is alike."""

from __future__ import annotations

from typing import Any

from torquerig.inference.addition import Addition
from torquerig.inference.answer.confidence import alternatives, equivalent_to
from torquerig.inference.engine import Outcome
from torquerig.inference.isolability.limits import as_limit, best_by_mechanism, smallest
from torquerig.inference.isolability.probes import hypotheses, probed
from torquerig.inference.isolability.separating import exchanged, separating_run
from torquerig.inference.isolability.signatures import Projection


def upper_limits(outcome: Outcome) -> list[dict[str, Any]]:
    """Return for each mechanism the smallest size that the recordings would have shown, in 95 % of such recordings."""
    known = outcome.data.seen[0].places
    context, places = probed(outcome.model.fit, outcome.runs, known)
    return [as_limit(each) for each in best_by_mechanism(smallest(Projection(context), hypotheses(context, places)))]


def next_experiment(outcome: Outcome, each: Addition) -> str | None:
    """Return which further run separates a finding from the nearest mechanism that it may be instead, or None."""
    alike = set(equivalent_to(outcome, each))
    other = next((one for one, _ in alternatives(outcome, each) if one.mechanism in alike), None)
    if other is None:
        return None
    fit = outcome.model.fit
    instead = exchanged(fit, outcome.data, less=each, more=other)
    if instead is None:
        return None
    names = (each.mechanism, other.mechanism)
    return separating_run(outcome.completed, instead, outcome.data.seen, fit.off, names=names)
