"""One's own matrix read from YAML: criteria, alternatives and what is known of each."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar

from torquerig.decide.cell import UNKNOWN, Cell
from torquerig.decide.criterion import YES_NO, Better, Criterion, Demand, Indifference, Kind, ValueFunction
from torquerig.decide.file_schema import STRICT, GoalText, ScaleText
from torquerig.decide.kesselring import TEACHING, Profile, rated_criteria
from torquerig.decide.matrix import DecisionMatrix
from torquerig.document import Document, read_document, validated
from torquerig.errors import InputError, TorquerigError, UnitError, did_you_mean
from torquerig.units import in_unit, parse_quantity, si_unit

Keys = tuple[str | int, ...]


@dataclass(frozen=True, kw_only=True)
class _Demand:
    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    min: float | None = None
    max: float | None = None
    in_question: str = ""


@dataclass(frozen=True, kw_only=True)
class _Indifference:
    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    absolute: float = 0.0
    relative: float = 0.0


@dataclass(frozen=True, kw_only=True)
class _Criterion:
    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    unit: str = "1"
    better: Better = Better.MORE
    band: tuple[float, float] | None = None
    demand: _Demand | None = None
    indifference: _Indifference = field(default_factory=_Indifference)
    points: tuple[tuple[float, float], ...] | None = None
    weight: float = 0.0
    kind: Kind = Kind.TECHNICAL
    purpose: str = ""


@dataclass(frozen=True, kw_only=True)
class _Cell:
    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    value: str | float | None = None
    low: str | float | None = None
    high: str | float | None = None
    text: str = ""
    source: str = ""
    evidence: str = ""
    note: str = ""
    unknown_reason: str = ""


@dataclass(frozen=True, kw_only=True)
class _File:
    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    criteria: dict[str, _Criterion]
    alternatives: dict[str, dict[str, Any]]
    name: str = "matrix"
    datum: str = ""
    goal: GoalText | None = None
    scale: ScaleText = field(default_factory=lambda: ScaleText(min=TEACHING.p_min, max=TEACHING.p_max))
    draws: int = 10_000
    seed: int = 0


@dataclass(frozen=True, kw_only=True)
class MatrixCase:
    """A matrix with how to judge it.

    Parameters
    ----------
    matrix : DecisionMatrix
    datum : str
        The alternative that Pugh starts from.
    profile : Profile
        The points scale.
    goal : str
    goal_words : tuple of str
        What a criterion's name must hold to ask for the goal.
    draws, seed : int
        For the probability of being best.
    """

    matrix: DecisionMatrix
    datum: str
    profile: Profile = TEACHING
    goal: str = ""
    goal_words: tuple[str, ...] = ()
    draws: int = 10_000
    seed: int = 0


def read_matrix(path: Path) -> MatrixCase:
    """Read a matrix file; InputError, UnitError or UnknownNameError name file, line, key and remedy."""
    return matrix_from(read_document(path))


def matrix_from(document: Document) -> MatrixCase:
    """Return the matrix of a YAML document that has been read; the first alternative is the datum if none is named."""
    from pydantic import TypeAdapter

    file = validated(document, TypeAdapter(_File))
    if not file.alternatives or not file.criteria:
        raise InputError(f"{document.place()}: a matrix needs criteria and alternatives; at least one of each")
    criteria = {name: _criterion(document, name, written) for name, written in file.criteria.items()}
    cells = {
        (alternative, name): _cell(document, ("alternatives", alternative, name), criteria)
        for alternative, given in file.alternatives.items()
        for name in given
    }
    datum = file.datum or next(iter(file.alternatives))
    if datum not in file.alternatives:
        hint = did_you_mean(datum, file.alternatives)
        raise InputError(f"{document.place(('datum',))}: the datum {datum!r} is not in the matrix; {hint}")
    if file.draws < 1:
        raise InputError(f"{document.place(('draws',))}: {file.draws} draws tell nothing; write 1 or more")
    matrix = DecisionMatrix(
        name=file.name, alternatives=tuple(file.alternatives), criteria=tuple(criteria.values()), cells=cells
    )
    return MatrixCase(
        matrix=matrix,
        datum=datum,
        profile=_profile(document, file, matrix),
        goal=file.goal.name if file.goal else "",
        goal_words=file.goal.words if file.goal else (),
        draws=file.draws,
        seed=file.seed,
    )


def _criterion(document: Document, name: str, written: _Criterion) -> Criterion:
    demand = written.demand
    try:
        return Criterion(
            name=name,
            unit=written.unit,
            better=written.better,
            band=written.band,
            demand=None if demand is None else Demand(low=demand.min, high=demand.max, in_question=demand.in_question),
            indifference=Indifference(absolute=written.indifference.absolute, relative=written.indifference.relative),
            value=None if written.points is None else ValueFunction(written.points),
            weight=written.weight,
            kind=written.kind,
            purpose=written.purpose,
        )
    except InputError as error:
        raise InputError(f"{document.place(('criteria', name))}: {_unnamed(error, name)}") from None


def _profile(document: Document, file: _File, matrix: DecisionMatrix) -> Profile:
    """Return the scale, after checking that every weighted criterion has points inside it."""
    try:
        scale = file.scale
        profile = Profile(name=f"{scale.min:g}-{scale.max:g}", p_min=scale.min, p_max=scale.max)
        rated_criteria(matrix, profile)
    except InputError as error:
        name = next((one for one in file.criteria if str(error).startswith(f"{one}: ")), None)
        keys: Keys = ("criteria",) if name is None else ("criteria", name)
        keys = ("scale",) if str(error).startswith("profile") else keys
        raise InputError(f"{document.place(keys)}: {_unnamed(error, name or matrix.name)}") from None
    return profile


def _cell(document: Document, keys: Keys, criteria: dict[str, Criterion]) -> Cell:
    from pydantic import TypeAdapter

    name = str(keys[-1])
    if name not in criteria:
        raise InputError(f"{document.place(keys)}: unknown criterion; {did_you_mean(name, criteria)}")
    data = document.data["alternatives"][keys[1]][name]
    unit = criteria[name].unit
    try:
        if isinstance(data, dict):
            adapter: TypeAdapter[_Cell] = TypeAdapter(_Cell)
            return _from_mapping(validated(document, adapter, within=keys), unit)
        if isinstance(data, list):
            if len(data) != 2:
                raise InputError("an interval has two ends; write [low, high]")
            return Cell(low=_number(data[0], unit), high=_number(data[1], unit))
        if data is None or data == "?":
            return UNKNOWN
        return Cell(value=_number(data, unit), text=_shown(data, unit))
    except TorquerigError as error:
        if str(error).startswith(str(document.path)):
            raise
        raise InputError(f"{document.place(keys)}: {error}") from None


def _from_mapping(written: _Cell, unit: str) -> Cell:
    value, low, high = (
        None if one is None or one == "?" else _number(one, unit) for one in (written.value, written.low, written.high)
    )
    return Cell(
        value=value,
        low=low,
        high=high,
        text=written.text or _shown(written.value, unit),
        source=written.source,
        evidence=written.evidence,
        note=written.note,
        unknown_reason=written.unknown_reason,
    )


def _number(written: Any, unit: str) -> float:
    """Return the number in the criterion's unit; text may be written in any unit of the same kind, or yes and no."""
    if unit == YES_NO:
        if isinstance(written, bool) or written in ("yes", "no"):
            return float(written in (True, "yes"))
        raise InputError(f"{written!r} is no answer; write yes, no or ?")
    if isinstance(written, bool) or not isinstance(written, str | int | float):
        raise InputError(f"{written!r} is no number; write a number [{unit}], [low, high] or ?")
    if isinstance(written, str):
        try:
            return in_unit(parse_quantity(written, si_unit(unit)), unit)
        except UnitError as error:
            raise InputError(f"{error}; or write a bare number [{unit}], [low, high] or ?") from None
    return float(written)


def _shown(written: Any, unit: str) -> str:
    return ("yes" if written in (True, "yes") else "no") if unit == YES_NO and written not in (None, "?") else ""


def _unnamed(error: InputError, name: str) -> str:
    return str(error).removeprefix(f"{name}: ")
