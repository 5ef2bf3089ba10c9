"""How sure an addition is: its share of the posterior mass of what was fitted in its place.

An addition won its round; every other hypothesis of that round is ``gap`` nats of posterior odds behind, and has the
mass ``exp(-gap)`` relative to it. A class is a mechanism together with the mechanisms that these recordings cannot tell
from it.
"""

from __future__ import annotations

from math import exp, log

from torquerig.inference.addition import Addition
from torquerig.inference.answer.numbers import MOST_SURE
from torquerig.inference.engine import Outcome

LEAST = 0.6  # share of the mass below which a name is not printed (the contract's limit)
ALIKE = log(20.0)  # [nats] of posterior odds: a hypothesis less far behind is not excluded (5 % against 95 %)


def alternatives(outcome: Outcome, each: Addition) -> list[tuple[Addition, float]]:
    """Return what was fitted in the place of an addition and by how many nats it is behind, the nearest first."""
    behind = [(other, gap) for added, other, gap in outcome.model.alternatives if added is each]
    return sorted(behind, key=lambda one: one[1])


def mechanisms_alike(outcome: Outcome, each: Addition) -> list[str]:
    """Return the other mechanisms that the recordings do not exclude in the place of an addition."""
    near = {other.mechanism for other, gap in alternatives(outcome, each) if gap < ALIKE and other.is_named}
    return sorted(near - {each.mechanism})


def equivalent_to(outcome: Outcome, each: Addition) -> list[str]:
    """Return what the recordings do not exclude in the place of a mechanism: mechanisms, then kinds without a name.

    A kind without a name does not belong to the class of the mechanism: it lowers the confidence.
    """
    near = (other for other, gap in alternatives(outcome, each) if gap < ALIKE and other.parts and not other.is_named)
    return [*mechanisms_alike(outcome, each), *sorted({other.kind for other in near})]


def confidence(outcome: Outcome, each: Addition) -> float:
    """Return the posterior mass of the class of an addition [1].

    For a mechanism the class is its name with the mechanisms of ``equivalent_to``; for a nameless effect and for a
    number of the rig it is all hypotheses of its kind.
    """
    names = {each.mechanism, *mechanisms_alike(outcome, each)} if each.is_named else {""}
    total = own = 1.0
    for other, gap in alternatives(outcome, each):
        total += exp(-gap)
        alike = other.mechanism in names and (each.is_named or other.kind == each.kind)
        own += exp(-gap) if alike else 0.0
    return min(own / total, MOST_SURE)


def named(outcome: Outcome) -> list[Addition]:
    """Return the additions that are sure enough to be named."""
    return [each for each in outcome.model.additions if each.is_named and confidence(outcome, each) >= LEAST]


def nameless(outcome: Outcome) -> list[Addition]:
    """Return the nameless effects, and mechanisms of which the recordings do not say enough to name them."""
    sure = {id(each) for each in named(outcome)}
    return [each for each in outcome.model.additions if id(each) not in sure and each.kind != "parameter"]


def far_numbers(outcome: Outcome) -> list[Addition]:
    """Return the numbers of the scenario that are surely far from what is stated."""
    return [each for each in _numbers(outcome) if confidence(outcome, each) >= LEAST]


def unsure_numbers(outcome: Outcome) -> list[Addition]:
    """Return those that may be another effect instead."""
    return [each for each in _numbers(outcome) if confidence(outcome, each) < LEAST]


def _numbers(outcome: Outcome) -> list[Addition]:
    return [each for each in outcome.model.additions if each.kind == "parameter"]
