"""The smallest size of each mechanism that recordings would show."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from torquerig.inference.addition import Addition
from torquerig.inference.isolability.signatures import Projection, Signature, is_shown, signature
from torquerig.parallel import parallel_map

_PER_MECHANISM = 3  # hypotheses of a mechanism that are followed to their smallest size


def smallest(projection: Projection, hypotheses: Iterable[Addition]) -> list[Signature]:
    """Return the hypotheses at their smallest visible sizes, at most ``_PER_MECHANISM`` of each mechanism.

    Those are chosen by how much they change at the medians of their priors.
    """
    found = parallel_map(lambda own: [signature(projection, each) for each in _clearest(projection, own)],
                         _by_mechanism(hypotheses))  # fmt: skip
    return [one for own in found for one in own if one is not None]


def smallest_of_each(projection: Projection, hypotheses: Iterable[Addition]) -> list[Signature]:
    """Return ``best_by_mechanism`` of ``smallest``: what is not shown at the size of another one is not followed."""

    def best(own: Sequence[Addition]) -> list[Signature]:
        found = list[Signature]()
        for each in _clearest(projection, own):
            if not found or is_shown(projection, each, found[0].reported.name, found[0].value):
                one = signature(projection, each)
                found = best_by_mechanism([*found, one]) if one is not None else found
        return found

    found = parallel_map(best, _by_mechanism(hypotheses))
    return best_by_mechanism([one for own in found for one in own])


def _by_mechanism(hypotheses: Iterable[Addition]) -> list[list[Addition]]:
    """Return the hypotheses of each mechanism."""
    answer: dict[str, list[Addition]] = {}
    for each in hypotheses:
        if each.is_named:
            answer.setdefault(each.mechanism, []).append(each)
    return list(answer.values())


def best_by_mechanism(found: Sequence[Signature]) -> list[Signature]:
    """Return the one of each mechanism whose smallest size is smallest, by name."""
    best: dict[str, Signature] = {}
    for each in found:
        other = best.get(each.addition.mechanism)
        if other is None or _smaller(each, other):
            best[each.addition.mechanism] = each
    return [best[name] for name in sorted(best)]


def as_limit(each: Signature) -> dict[str, Any]:
    """Return the limit in the form of the contract, with the place that it holds for."""
    return {
        "mechanism": each.addition.mechanism, "parameter": each.reported.name,
        "value": float(f"{abs(each.value):.3g}"), "unit": each.reported.unit, "place": each.addition.label,
        "grows": "down" if each.grows_down else "up",
    }  # fmt: skip


def _smaller(one: Signature, other: Signature) -> bool:
    if one.reported.name != other.reported.name:
        return False
    return abs(one.value) > abs(other.value) if one.grows_down else abs(one.value) < abs(other.value)


def _clearest(projection: Projection, own: Sequence[Addition]) -> list[Addition]:
    import numpy as np

    if len(own) <= _PER_MECHANISM:
        return list(own)
    sizes = []
    for each in own:
        change = projection.change(each, np.zeros(len(each.knobs)))
        sizes.append(0.0 if change is None else float(np.linalg.norm(change)))
    return [own[at] for at in np.argsort(sizes)[::-1][:_PER_MECHANISM].tolist()]
