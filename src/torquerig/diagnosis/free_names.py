"""Names for effects that a scenario already has, so that a diagnosis may add another of their kind."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields, replace

from torquerig.rig.assembly import Part
from torquerig.scenario.model import Scenario

_KEPT = ("kind", "group")


def with_free_names(scenario: Scenario, names: Iterable[str]) -> Scenario:
    """Return the scenario with every part that has one of ``names`` called ``NAME_of_scenario``, wherever it is named.

    A model that a diagnosis wrote names its findings by their class; given back as the nominal one, it may lack a
    second of the class.
    """
    taken = {part.name for part in scenario.rig.parts}
    new = {name: f"{name}_of_scenario" for name in names if name in taken}
    if not new:
        return scenario
    rig = replace(scenario.rig, parts=tuple(_renamed(part, new) for part in scenario.rig.parts))
    uncertain = {}
    for key, estimate in scenario.uncertainties.items():
        part = next((name for name in new if key.startswith(f"{name}.")), None)
        uncertain[key if part is None else f"{new[part]}{key.removeprefix(part)}"] = estimate
    return replace(scenario, rig=rig, uncertainties=uncertain)


def _renamed(part: Part, new: dict[str, str]) -> Part:
    changes = {
        field.name: new[value]
        for field in fields(part)
        if field.name not in _KEPT and isinstance(value := getattr(part, field.name), str) and value in new
    }
    return replace(part, **changes) if changes else part
