"""A user's matrix read from YAML: criteria, alternatives and cells."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.decide.case import Cost, MatrixCase
from torquerig.decide.criterion import Criterion, Indifference, Requirement, ValueFunction
from torquerig.decide.kesselring import Profile, rated_criteria
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.matrix_cells import Cells, Keys, catalog_cells, written_cells
from torquerig.decide.matrix_io.matrix_schema import CriterionText, MatrixText
from torquerig.decide.matrix_io.matrix_table import Alias
from torquerig.decide.monte_carlo import Uncertainty
from torquerig.document import Document, read_document, validated, with_new_keys
from torquerig.errors import InputError, did_you_mean

if TYPE_CHECKING:
    from torquerig.catalog.reading import Catalog

__all__ = ["MatrixCase", "matrix_from", "read_matrix"]

MOST_DRAWS = 1_000_000
OLD_KEYS = {("datum",): "baseline", ("doubt",): "uncertainty", ("criteria", "*", "demand"): "requirement"}
"""Paths of keys that files of earlier versions have, and the names that they have now."""


def read_matrix(path: Path, *, catalog: Catalog | None = None) -> MatrixCase:
    """Read a matrix file; InputError, UnitError or UnknownNameError name file, line, key and remedy."""
    return matrix_from(read_document(path), catalog=catalog)


def matrix_from(document: Document, *, catalog: Catalog | None = None) -> MatrixCase:
    """Return the matrix of a document that has been read; the first alternative is the baseline if none is named.

    ``catalog`` is used where the file has ``motors:``; the default is the shipped catalog.
    """
    from pydantic import TypeAdapter

    if not isinstance(document.data, dict):
        raise InputError(f"{document.place()}: no matrix; write criteria: and alternatives:, as in matrix_example.yaml")
    document = with_new_keys(document, OLD_KEYS)
    file = validated(document, TypeAdapter(MatrixText))
    if not file.alternatives or not file.criteria:
        raise InputError(f"{document.place()}: a matrix needs criteria and alternatives; at least one of each")
    for key in ("criteria", "alternatives"):
        if any(not name.strip() for name in document.data[key]):
            raise InputError(f"{document.place((key, ''))}: a name is empty; write a name")
    criteria = {name: _criterion(document, name, written) for name, written in file.criteria.items()}
    cells = {**_cells_of_motors(document, file, criteria, catalog), **written_cells(document, file, criteria)}
    matrix = DecisionMatrix(
        name=file.name, alternatives=tuple(file.alternatives), criteria=tuple(criteria.values()), cells=cells
    )
    profile = _profile(document, file, matrix)
    _check_points_by_hand(document, cells, profile)
    if file.draws > MOST_DRAWS:
        raise InputError(f"{document.place(('draws',))}: {file.draws} Monte Carlo samples are too many; the most are "
                         f"{MOST_DRAWS}, which resolve shares of 0.1 %")  # fmt: skip
    if file.draws < 1:
        raise InputError(f"{document.place(('draws',))}: {file.draws} Monte Carlo samples are too few; write 1 or more")
    return MatrixCase(
        matrix=matrix,
        baseline=_baseline(document, file),
        profile=profile,
        goal=file.goal.name if file.goal else "",
        goal_words=file.goal.words if file.goal else (),
        draws=file.draws,
        seed=file.seed,
        uncertainty=_uncertainty(document, file),
        cost=_cost(document, file),
        aliases=tuple(
            Alias(names=one.names, reason=one.reason, place=document.place(("aliases", place)))
            for place, one in enumerate(file.aliases)
        ),
        history=file.history,
        places={name: document.place(("criteria", name)) for name in criteria},
    )


def _cells_of_motors(
    document: Document, file: MatrixText, criteria: dict[str, Criterion], catalog: Catalog | None
) -> Cells:
    if not file.motors:
        wanting = next((name for name, one in file.criteria.items() if one.catalog), None)
        if wanting:
            place = document.place(("criteria", wanting, "catalog"))
            raise InputError(f"{place}: no alternative has a motor; add motors: {{alternative: name in the catalog}}")
        return {}
    if catalog is None:
        from torquerig.catalog.reading import load_catalog
        from torquerig.catalog.shipped import shipped_folder

        catalog = load_catalog(shipped_folder())
    return catalog_cells(document, file, criteria, catalog)


def _baseline(document: Document, file: MatrixText) -> str:
    baseline = file.baseline or next(iter(file.alternatives))
    if baseline not in file.alternatives:
        hint = did_you_mean(baseline, file.alternatives)
        raise InputError(f"{document.place(('baseline',))}: the baseline {baseline!r} is not in the matrix; {hint}")
    return baseline


def _criterion(document: Document, name: str, written: CriterionText) -> Criterion:
    requirement = written.requirement
    try:
        return Criterion(
            name=name,
            unit=written.unit,
            better=written.better,
            band=written.band,
            requirement=None
            if requirement is None
            else Requirement(low=requirement.min, high=requirement.max, in_question=requirement.in_question),
            indifference=Indifference(absolute=written.indifference.absolute, relative=written.indifference.relative),
            value=None if written.points is None else ValueFunction(written.points),
            weight=written.weight,
            kind=written.kind,
            purpose=written.purpose,
        )
    except InputError as error:
        problem = _unnamed(error, name)
        raise InputError(f"{document.place(('criteria', name, _key_of(problem)))}: {problem}") from None


def _profile(document: Document, file: MatrixText, matrix: DecisionMatrix) -> Profile:
    """Return the scale, after checking that every weighted criterion has points inside it."""
    try:
        scale = file.scale
        profile = Profile(name=f"{scale.min:g}-{scale.max:g}", p_min=scale.min, p_max=scale.max)
        rated_criteria(matrix, profile)
    except InputError as error:
        name = next((one for one in file.criteria if str(error).startswith(f"{one}: ")), None)
        keys: Keys = ("criteria",) if name is None else ("criteria", name, _key_of(_unnamed(error, name)))
        keys = ("scale",) if str(error).startswith("profile") else keys
        raise InputError(f"{document.place(keys)}: {_unnamed(error, name or matrix.name)}") from None
    return profile


def _check_points_by_hand(document: Document, cells: Cells, profile: Profile) -> None:
    for pair, cell in cells.items():
        given = cell.points_by_hand
        if given is not None and not profile.p_min <= given <= profile.p_max:
            place = document.place(("alternatives", *pair, "by_hand", "points"))
            raise InputError(f"{place}: {profile.refusal(given)}")


def _uncertainty(document: Document, file: MatrixText) -> Uncertainty:
    try:
        return Uncertainty(scores=file.uncertainty.scores, weights=file.uncertainty.weights)
    except InputError as error:
        raise InputError(f"{document.place(('uncertainty',))}: {error}") from None


def _cost(document: Document, file: MatrixText) -> Cost | None:
    if file.cost is None:
        return None
    if file.cost.criterion not in file.criteria:
        hint = did_you_mean(file.cost.criterion, file.criteria)
        raise InputError(f"{document.place(('cost', 'criterion'))}: unknown criterion {file.cost.criterion!r}; {hint}")
    if not 0 < file.cost.permissible < float("inf"):
        place = document.place(("cost", "permissible"))
        raise InputError(f"{place}: the permissible cost {file.cost.permissible:g} must be above 0")
    return Cost(criterion=file.cost.criterion, permissible=file.cost.permissible)


def _key_of(problem: str) -> str:
    """Return the key of a criterion that an error is about, for its place."""
    if "points are outside" in problem:
        return "points"
    about = {"weight": "the weight", "points": "the value", "band": "the band", "requirement": "the requirement",
             "indifference": "the "}  # fmt: skip
    return next((key for key, start in about.items() if problem.startswith(start)), "")


def _unnamed(error: InputError, name: str) -> str:
    return str(error).removeprefix(f"{name}: ")
