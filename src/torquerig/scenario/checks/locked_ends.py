"""Stated inertia and friction of shafts that are fixed to the frame, which rest and so have no effect."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from torquerig.errors import TorquerigError
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import GROUND, BristleFriction, Friction, Inertia, Term
from torquerig.scenario.model import Scenario

CHANGED = 1.01  # [1] any other value shows whether a key counts


def at_locked_ends(scenario: Scenario) -> Iterator[str]:
    """Yield each stated key of a part that only changes what rests at a locked end, with the reason."""
    rig, written = scenario.rig, scenario.document.data.get("rig") or {}
    for part in rig.parts:
        if not any(_rests(term) for term in part.terms(rig)):
            continue
        for key in written.get(part.name) or ():
            if _only_at_rest(rig, part, str(key)):
                yield f"rig.{part.name}.{key}: it is on a shaft that is fixed to the frame and does not move"


def _only_at_rest(rig: Rig, part: Part, key: str) -> bool:
    value = getattr(part, key, None)
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        changed_value: dict[str, Any] = {key: CHANGED * value}
        other = replace(part, **changed_value)
        terms, changed = part.terms(rig), other.terms(rig.changed(other))
    except (TorquerigError, ValueError, TypeError):
        return False
    return terms != changed and _moving(terms) == _moving(changed)


def _moving(terms: tuple[Term, ...]) -> list[Term]:
    return [term for term in terms if not _rests(term)]


def _rests(term: Term) -> bool:
    """Whether a term is an inertia or a friction of the frame."""
    if isinstance(term, Inertia):
        return term.node == GROUND
    return isinstance(term, Friction | BristleFriction) and term.on == GROUND and term.against == GROUND
