"""The three matrices as numbers from which the page computes them again: ``solveMatrices`` in matrix_engine.js."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isnan
from typing import TYPE_CHECKING, Any

from torquerig.decide.kesselring import TEACHING, Profile
from torquerig.decide.strength import IDEAL_SHARE

if TYPE_CHECKING:
    from torquerig.decide.case import MatrixCase
    from torquerig.decide.cell import Cell
    from torquerig.decide.criterion import Criterion
    from torquerig.decide.matrix import DecisionMatrix


def study_model(
    requirements: DecisionMatrix, criteria: DecisionMatrix, *, baseline: str, drive_of: Mapping[str, str]
) -> dict[str, Any]:
    """Return the matrices of a study: requirements on drives, criteria on each drive with each filter.

    Parameters
    ----------
    criteria : DecisionMatrix
        Of all simulated combinations, also those that a requirement eliminates.
    drive_of : mapping of str to str
        The drive of each combination.
    """
    groups = list(requirements.alternatives)
    return _model(
        groups, requirements, [(name, groups.index(drive_of[name])) for name in criteria.alternatives], criteria,
        profile=TEACHING, baseline=baseline, keeps_baseline=True, pugh_of_all=False,
    )  # fmt: skip


def case_model(case: MatrixCase) -> dict[str, Any]:
    """Return the matrices of a decision matrix, whose requirements and criteria are in one table."""
    matrix = case.matrix
    made = _model(
        list(matrix.alternatives), matrix, [(name, row) for row, name in enumerate(matrix.alternatives)], matrix,
        profile=case.profile, baseline=case.baseline, keeps_baseline=False, pugh_of_all=True,
    )  # fmt: skip
    if case.cost is not None:
        costs = [_numbers(matrix.cell(name, case.cost.criterion)) for name in matrix.alternatives]
        made["cost"] = {"cells": costs, "ideal": IDEAL_SHARE * case.cost.permissible}
    return made


def _model(
    groups: Sequence[str], limits: DecisionMatrix, rows: Sequence[tuple[str, int]], matrix: DecisionMatrix, *,
    profile: Profile, baseline: str, keeps_baseline: bool, pugh_of_all: bool,
) -> dict[str, Any]:  # fmt: skip
    required = [one for one in limits.criteria if one.requirement is not None]
    return {
        "profile": {"min": profile.p_min, "max": profile.p_max},
        "groups": list(groups),
        "rows": [{"name": name, "group": group} for name, group in rows],
        "requirements": [_requirement(one) for one in required],
        "limits": [[_numbers(limits.cell(group, one.name)) for one in required] for group in groups],
        "criteria": [_criterion(one) for one in matrix.criteria],
        "cells": [[_numbers(matrix.cell(name, one.name)) for one in matrix.criteria] for name, _ in rows],
        "baseline": matrix.index(baseline), "keepsBaseline": keeps_baseline, "pughOfAll": pugh_of_all, "cost": None,
    }  # fmt: skip


def _requirement(one: Criterion) -> dict[str, Any]:
    assert one.requirement is not None
    return {"name": one.name, "unit": one.unit, "low": one.requirement.low, "high": one.requirement.high,
            "inQuestion": bool(one.requirement.in_question)}  # fmt: skip


def _criterion(one: Criterion) -> dict[str, Any]:
    return {
        "name": one.name, "unit": one.unit, "better": str(one.better), "band": one.band, "kind": str(one.kind),
        "absolute": one.indifference.absolute, "relative": one.indifference.relative, "weight": one.weight,
        "knots": None if one.value is None else [list(knot) for knot in one.value.knots],
    }  # fmt: skip


def _numbers(cell: Cell) -> dict[str, float | None]:
    low, high = cell.bounds
    return {
        "value": cell.used.value, "low": None if isnan(low) else low, "high": None if isnan(high) else high,
        "points": cell.points_by_hand,
    }  # fmt: skip
