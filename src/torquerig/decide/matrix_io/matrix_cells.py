"""The cells of a user's matrix: as written in the file, or from the catalog's motors."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from torquerig.decide.cell import UNKNOWN, Cell, Origin, Override
from torquerig.decide.criterion import YES_NO, Criterion
from torquerig.decide.matrix_io.matrix_schema import CellText, MatrixText
from torquerig.document import Document, validated
from torquerig.errors import InputError, TorquerigError, UnitError, UnknownNameError, did_you_mean
from torquerig.units import in_unit, parse_quantity, si_unit

if TYPE_CHECKING:
    from torquerig.catalog.reading import Catalog
    from torquerig.parameter import Estimate

Keys = tuple[str | int, ...]
Cells = dict[tuple[str, str], Cell]


def written_cells(document: Document, file: MatrixText, criteria: dict[str, Criterion]) -> Cells:
    """Return the cells that the file holds; InputError with file, line and key for one that cannot be used."""
    return {
        (alternative, name): _cell(document, ("alternatives", alternative, name), criteria)
        for alternative, given in file.alternatives.items()
        for name in given or {}
    }


def catalog_cells(document: Document, file: MatrixText, criteria: dict[str, Criterion], catalog: Catalog) -> Cells:
    """Return a cell for each motor named under ``motors`` and each criterion with a ``catalog`` key."""
    from torquerig.catalog.entry import estimates

    cells: Cells = {}
    for alternative, motor in file.motors.items():
        place = document.place(("motors", alternative))
        if alternative not in file.alternatives:
            raise InputError(f"{place}: unknown alternative; {did_you_mean(alternative, file.alternatives)}")
        try:
            known = dict(estimates(catalog.motor(motor)))
        except UnknownNameError as error:
            raise UnknownNameError(f"{place}: {error}") from None
        for name, criterion in criteria.items():
            key = file.criteria[name].catalog
            if key and key not in known:
                where = document.place(("criteria", name, "catalog"))
                raise InputError(f"{where}: a motor's file has no {key!r}; {did_you_mean(key, known)}")
            if key:
                cells[alternative, name] = _from_catalog(document, criterion, motor, key=key, known=known[key])
    return cells


def _from_catalog(document: Document, criterion: Criterion, motor: str, *, key: str, known: Estimate) -> Cell:
    if si_unit(criterion.unit) != si_unit(known.unit):
        place = document.place(("criteria", criterion.name, "unit"))
        raise InputError(f"{place}: {key} of a motor is in {known.unit!r}, not in {criterion.unit!r}; correct the unit")
    cell, fact = Cell.from_estimate(known, criterion.unit), f"{key.replace('_', ' ').replace('.', ' ')} of {motor}"
    origin = Origin(name=fact, shown=known.shown(criterion.unit), evidence=known.evidence, source=known.source)
    return Cell(
        value=cell.value, low=cell.low, high=cell.high, source=known.source, evidence=known.evidence, note=known.note,
        unknown_reason="" if cell.known else fact, fact=fact, origins=(origin,), metric="catalog value, unchanged",
    )  # fmt: skip


def _cell(document: Document, keys: Keys, criteria: dict[str, Criterion]) -> Cell:
    from pydantic import TypeAdapter

    name = str(keys[-1])
    if name not in criteria:
        raise InputError(f"{document.place(keys)}: unknown criterion; {did_you_mean(name, criteria)}")
    data = document.data["alternatives"][keys[1]][name]
    unit = criteria[name].unit
    try:
        if isinstance(data, dict):
            adapter: TypeAdapter[CellText] = TypeAdapter(CellText)
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


def _from_mapping(written: CellText, unit: str) -> Cell:
    value, low, high = (
        None if one is None or one == "?" else _number(one, unit) for one in (written.value, written.low, written.high)
    )
    hand = written.by_hand
    return Cell(
        value=value,
        low=low,
        high=high,
        text=written.text or _shown(written.value, unit),
        source=written.source,
        evidence=written.evidence,
        note=written.note,
        unknown_reason=written.unknown_reason,
        fact=written.fact,
        metric=written.metric,
        origins=tuple(
            Origin(name=one.name, shown=one.shown, evidence=one.evidence, source=one.source) for one in written.origins
        ),
        by_hand=None
        if hand is None
        else Override(
            reason=hand.reason, points=hand.points, value=None if hand.value is None else _number(hand.value, unit)
        ),
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
