"""Weights, limits and points that were moved on the page, as edits of the scenario or of a matrix file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import isclose
from typing import Any

from torquerig.studio.session.working_document import WorkingDocument
from torquerig.studio.session.yaml_spans import Keys

SAME = 1e-12  # [1] relative: the page holds the numbers of the file as they are


def moved_values(document: WorkingDocument, moved: Mapping[str, Any]) -> tuple[tuple[Keys, float], ...]:
    """Return path and number of each value that differs from the file.

    Parameters
    ----------
    document : WorkingDocument
        A scenario with its study, or a matrix.
    moved : mapping
        The matrices as the page holds them; see ``reporting.moving.matrix_model``.
    """
    found = [*_criteria(document, moved.get("criteria", ())), *_limits(document, moved.get("requirements", ()))]
    return tuple((keys, number) for keys, number in found if not _is(document.value(*keys), number))


def _criteria(document: WorkingDocument, criteria: Any) -> Iterator[tuple[Keys, float]]:
    for one in criteria:
        where = _criterion(document, str(one["name"]))
        if not isinstance(document.value(*where), dict):
            continue
        if one["weight"] or document.value(*where, "weight") is not None:  # without one it is 0
            yield (*where, "weight"), float(one["weight"])
        stated = document.value(*where, "points")
        for value, points in one.get("knots") or ():
            key = next((name for name in stated or () if _is(name, float(value))), None)
            if key is not None:
                yield (*where, "points", key), float(points)


def _limits(document: WorkingDocument, requirements: Any) -> Iterator[tuple[Keys, float]]:
    for one in requirements:
        name = str(one["name"])
        where: Keys = ("study", "requirements", name)
        if document.kind == "matrix":
            where = (*_criterion(document, name), "requirement")
        for end, key in (("low", "min"), ("high", "max")):
            if one.get(end) is not None and document.value(*where, key) is not None:
                yield (*where, key), float(one[end])


def _criterion(document: WorkingDocument, name: str) -> Keys:
    return ("criteria", name) if document.kind == "matrix" else ("study", "criteria", name)


def _is(stated: Any, number: float) -> bool:
    return isinstance(stated, int | float) and isclose(stated, number, rel_tol=SAME, abs_tol=SAME)
