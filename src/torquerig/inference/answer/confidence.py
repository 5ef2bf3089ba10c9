"""How sure an addition is, compared with what was fitted in its place.

An addition won its round; every other hypothesis of that round is some nats of posterior odds behind. A class is a
mechanism together with what these recordings do not separate from it.
"""

from __future__ import annotations

from math import exp, inf, log

from torquerig.inference.addition import Addition
from torquerig.inference.engine import Outcome

COMPLETE = 0.93  # probability that the cause is among the hypotheses; set by hand, few trials have been counted yet
TEMPER = 4.0  # [nats] of posterior odds that count for one; set by hand
LEAST = 0.6  # confidence below which a name is not printed (the contract's limit)
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
    """Return what the recordings do not exclude in the place of a mechanism: mechanisms, then kinds without a name."""
    near = {other.kind for other, gap in alternatives(outcome, each) if gap < ALIKE and _is_nameless(other)}
    return [*mechanisms_alike(outcome, each), *sorted(near)]


def confidence(outcome: Outcome, each: Addition) -> float:
    """Return how probable it is that an addition is of the right class [1].

    With d nats of posterior odds to the nearest hypothesis outside the class it is ``COMPLETE / (1 + exp(-d /
    TEMPER))``. Features share errors of the model that the likelihood takes for independent ones: odds count for less
    than their nats (coarsened posterior: Miller & Dunson 2019, J. Am. Stat. Assoc. 114). And the cause may be none of
    the hypotheses.

    For a mechanism the class is its name with all of ``equivalent_to``; for a nameless effect and for a number of the
    rig it is all hypotheses of its kind.
    """
    names = {each.mechanism, *mechanisms_alike(outcome, each)}
    apart = [
        gap for other, gap in alternatives(outcome, each)
        if not (other.mechanism in names or (gap < ALIKE and _is_nameless(other)) if each.is_named
                else not other.is_named and other.kind == each.kind)
    ]  # fmt: skip
    return COMPLETE / (1 + exp(-min(apart, default=inf) / TEMPER))


def _is_nameless(other: Addition) -> bool:
    return bool(other.parts) and not other.is_named


def named(outcome: Outcome) -> list[Addition]:
    """Return the additions that are sure enough to be named, and leave little of the features that they explain."""
    refuted = {id(each) for each in outcome.model.refuted}
    return [
        each for each in outcome.model.additions
        if each.is_named and id(each) not in refuted and confidence(outcome, each) >= LEAST
    ]  # fmt: skip


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
