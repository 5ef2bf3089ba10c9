"""A user's matrix written as YAML: reading it again gives the same case."""

from __future__ import annotations

import re
from dataclasses import fields
from typing import Any

from torquerig.decide.case import MatrixCase
from torquerig.decide.cell import UNKNOWN, Cell
from torquerig.decide.criterion import YES_NO, Criterion

PLAIN = re.compile(r"[A-Za-z](?:[\w .*^/-]*\w)?")
RESERVED = frozenset({"yes", "no", "on", "off", "true", "false", "null", "y", "n"})


def matrix_yaml(case: MatrixCase) -> str:
    """Return the YAML of a case; values from the catalog are in its cells with their origin."""
    import yaml

    class Dumper(yaml.SafeDumper):
        """Quotes every text that some version of YAML could take for something else."""

    def text(dumper: yaml.SafeDumper, held: str) -> yaml.ScalarNode:
        plain = PLAIN.fullmatch(held) and held.lower() not in RESERVED
        return dumper.represent_scalar("tag:yaml.org,2002:str", held, style=None if plain else '"')

    Dumper.add_representer(str, text)
    return yaml.dump(
        case_data(case), Dumper=Dumper, sort_keys=False, allow_unicode=True, width=120, default_flow_style=None
    )


def case_data(case: MatrixCase) -> dict[str, Any]:
    """Return a case as the mappings and lists of its file; defaults are left out."""
    matrix, data = case.matrix, {"name": case.matrix.name}
    full: dict[str, Any] = {
        **data,
        "goal": {"name": case.goal, "words": list(case.goal_words)} if case.goal else None,
        "scale": {"min": case.profile.p_min, "max": case.profile.p_max},
        "baseline": case.baseline,
        "draws": case.draws,
        "seed": case.seed,
        "uncertainty": {"scores": case.uncertainty.scores, "weights": case.uncertainty.weights},
        "cost": {"criterion": case.cost.criterion, "permissible": case.cost.permissible} if case.cost else None,
        "aliases": [{"names": list(one.names), "reason": one.reason} for one in case.aliases],
        "history": list(case.history),
        "criteria": {criterion.name: _criterion(criterion) for criterion in matrix.criteria},
        "alternatives": {
            name: {
                one.name: cell_data(cell, one.unit)
                for one in matrix.criteria
                if (cell := matrix.cell(name, one.name)) != UNKNOWN
            }
            for name in matrix.alternatives
        },
    }
    return {key: value for key, value in full.items() if value not in (None, [])}


def cell_data(cell: Cell, unit: str) -> Any:
    """Return a cell as short as the file allows: a number, ``[low, high]``, yes or no, ``?`` or a mapping."""
    if cell == UNKNOWN:
        return "?"
    if unit == YES_NO and cell == Cell(value=cell.value, text=_answer(cell.value)):
        return cell.text
    if unit != YES_NO and cell == Cell(value=cell.value):
        return cell.value
    if unit != YES_NO and cell == Cell(low=cell.low, high=cell.high):
        return [cell.low, cell.high]
    data = _filled(cell)
    if cell.origins:
        data["origins"] = [_filled(origin) for origin in cell.origins]
    if cell.by_hand is not None:
        data["by_hand"] = _filled(cell.by_hand)
    if unit == YES_NO:
        for held in (data, data.get("by_hand", {})):
            held |= {key: _answer(held[key]) for key in ("value", "low", "high") if key in held}
    return data


def _answer(value: float | None) -> str:
    return "yes" if value else "no"


def _filled(record: Any) -> dict[str, Any]:
    held = {one.name: getattr(record, one.name) for one in fields(record)}
    return {key: value for key, value in held.items() if value not in (None, "", ())}


def _criterion(criterion: Criterion) -> dict[str, Any]:
    requirement, same = criterion.requirement, criterion.indifference
    full: dict[str, Any] = {
        "unit": criterion.unit,
        "better": str(criterion.better),
        "band": None if criterion.band is None else list(criterion.band),
        "requirement": None
        if requirement is None
        else {
            key: value
            for key, value in (
                ("min", requirement.low),
                ("max", requirement.high),
                ("in_question", requirement.in_question),
            )
            if value not in (None, "")
        },
        "indifference": {"absolute": same.absolute, "relative": same.relative}
        if same.absolute or same.relative
        else None,
        "points": None if criterion.value is None else [list(knot) for knot in criterion.value.knots],
        "weight": criterion.weight or None,
        "kind": str(criterion.kind),
        "purpose": criterion.purpose or None,
    }
    return {key: value for key, value in full.items() if value is not None}
