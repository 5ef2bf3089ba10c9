"""Published tables read from YAML, cell by cell as printed; every error names file, line and key."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar

from torquerig.decide.criterion import Kind
from torquerig.decide.kesselring import Profile
from torquerig.decide.matrix_io.file_schema import STRICT, GoalText, ScaleText
from torquerig.decide.matrix_io.matrix_table import SAME, UNKNOWN, Alias, Entry, MatrixTable, Method, Row, TableSet
from torquerig.decide.matrix_io.written_values import may_be_thousands, number_of, pugh_mark, weight_of
from torquerig.document import Document, read_document, validated, with_new_keys
from torquerig.errors import InputError, did_you_mean

OLD_KEYS = {("tables", "*", "datum"): "baseline", ("tables", "*", "rows", "*", "datum_has"): "baseline_has"}
"""Paths of keys that files of earlier versions have, and the names that they have now."""
_MARKS = {Method.ELIMINATION: ("+", "-", "?", "!"), Method.PUGH: ("++", "+", "-", "--", "0", "S", "?")}
_PROCEED = {"yes": True, "no": False}

Keys = tuple[str | int, ...]


@dataclass(frozen=True, kw_only=True)
class _Row:
    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    cells: tuple[str | float | None, ...]
    proceed: str | None = None
    weight: float | str | None = None
    products: tuple[float | None, ...] = ()
    kind: Kind = Kind.TECHNICAL
    baseline_has: bool = False
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class _Table:
    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    name: str
    method: Method
    columns: tuple[str, ...]
    rows: dict[str, _Row]
    section: str = ""
    title: str = ""
    baseline: str = ""
    ideal: str = ""
    scale: ScaleText = field(default_factory=lambda: ScaleText(min=1, max=5))
    follows_rating: tuple[str, ...] = ()
    sums: tuple[float | None, ...] = ()
    ranks: tuple[int | None, ...] = ()
    spare_sums: tuple[float, ...] = ()
    reading_of: str = ""
    printed: str = ""
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class _Alias:
    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    names: tuple[str, ...]
    reason: str = ""


@dataclass(frozen=True, kw_only=True)
class TablesText:
    """A file of published tables."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    tables: tuple[_Table, ...]
    source: str = ""
    goal: GoalText | None = None
    ratings: dict[str, str] = field(default_factory=dict)
    aliases: tuple[_Alias, ...] = ()


def read_tables(path: Path) -> TableSet:
    """Read a file of published tables.

    Raises
    ------
    InputError
        One sentence with file, line, key and remedy: unknown keys or marks, a row of the wrong length, names that
        occur twice, points outside the scale, negative or all-zero weights, a baseline that is no column.
    """
    return tables_from(read_document(path))


def tables_from(document: Document) -> TableSet:
    """Return the tables of a YAML document that has been read; errors as in :func:`read_tables`."""
    from pydantic import TypeAdapter

    document = with_new_keys(document, OLD_KEYS)
    file = validated(document, TypeAdapter(TablesText))
    _refuse_twice(document, ("tables",), [table.name for table in file.tables], what="table")
    return TableSet(
        tables=tuple(_matrix_table(document, place, table) for place, table in enumerate(file.tables)),
        goal=file.goal.name if file.goal else "",
        goal_words=file.goal.words if file.goal else (),
        ratings=file.ratings,
        aliases=tuple(
            Alias(names=alias.names, reason=alias.reason, place=document.place(("aliases", place)))
            for place, alias in enumerate(file.aliases)
        ),
        source=file.source,
    )


def _matrix_table(document: Document, place: int, table: _Table) -> MatrixTable:
    keys: Keys = ("tables", place)
    _refuse_twice(document, (*keys, "columns"), table.columns, what="column")
    for name, row in table.rows.items():
        for key, given in (("cells", row.cells), ("products", row.products)):
            if given and len(given) != len(table.columns):
                _fail(document, (*keys, "rows", name, key), f"{len(given)} cells for {len(table.columns)} columns; "
                      "write one for each, ? where it is unknown")  # fmt: skip
    if table.method is Method.ELIMINATION:
        return _elimination(document, keys, table)
    return _by_columns(document, keys, table)


def _elimination(document: Document, keys: Keys, table: _Table) -> MatrixTable:
    passed = []
    for name, row in table.rows.items():
        for entry in row.cells:
            _mark(document, (*keys, "rows", name, "cells"), entry, table.method)
        if row.proceed is not None and row.proceed.lower() not in _PROCEED:
            _fail(document, (*keys, "rows", name, "proceed"), f'{row.proceed!r} is no decision; write "Yes" or "No"')
        passed.append(None if row.proceed is None else _PROCEED[row.proceed.lower()])
    for name in table.follows_rating:
        if name not in table.columns:
            _fail(document, (*keys, "follows_rating"), f"{name!r} is no column; {did_you_mean(name, table.columns)}")
    rows = tuple(
        Row(
            criterion=criterion,
            entries=tuple(
                str(_mark(document, (*keys, "rows", name, "cells"), row.cells[column], table.method))
                for name, row in table.rows.items()
            ),
            place=document.place((*keys, "columns", column)),
            follows_rating=criterion in table.follows_rating,
        )
        for column, criterion in enumerate(table.columns)
    )
    return MatrixTable(
        name=table.name,
        method=table.method,
        alternatives=tuple(table.rows),
        rows=rows,
        passed=tuple(passed),
        title=table.title,
        section=table.section,
        place=document.place(keys),
        reading_of=table.reading_of,
        printed=table.printed,
        note=table.note,
    )


def _by_columns(document: Document, keys: Keys, table: _Table) -> MatrixTable:
    key = "baseline" if table.method is Method.PUGH else "ideal"
    apart = table.baseline if table.method is Method.PUGH else table.ideal
    if (apart or table.method is Method.PUGH) and apart not in table.columns:
        _fail(document, (*keys, key), f"the {key} {apart!r} is not in the table; {did_you_mean(apart, table.columns)}")
    for printed in ("sums", "ranks"):
        given = getattr(table, printed)
        if given and len(given) != len(table.columns):
            _fail(document, (*keys, printed), f"{len(given)} values for {len(table.columns)} columns; write ~ for none")
    kept = [column for column, name in enumerate(table.columns) if name != apart]
    ideal = table.columns.index(apart) if apart in table.columns else None
    profile = _profile(document, keys, table)
    weights = _checked_weights(document, keys, table)
    return MatrixTable(
        name=table.name,
        method=table.method,
        alternatives=tuple(table.columns[column] for column in kept),
        rows=tuple(_row(document, (*keys, "rows", name), table, kept, weights[name]) for name in table.rows),
        baseline=table.baseline,
        sums=tuple(table.sums[column] for column in kept) if table.sums else (),
        ranks=tuple(table.ranks[column] for column in kept) if table.ranks else (),
        spare_sums=table.spare_sums,
        ideal_sum=table.sums[ideal] if table.sums and ideal is not None else None,
        profile=profile,
        title=table.title,
        section=table.section,
        place=document.place(keys),
        reading_of=table.reading_of,
        printed=table.printed,
        note=table.note,
    )


def _row(document: Document, keys: Keys, table: _Table, kept: Sequence[int], weight: float | None) -> Row:
    name = str(keys[-1])
    row = table.rows[name]
    if table.method is Method.PUGH:
        baseline = row.cells[table.columns.index(table.baseline)]
        if baseline not in (*SAME, "REF", table.baseline) and pugh_mark(baseline) != "S":
            _fail(document, (*keys, "cells"), f"the cell of the baseline is {baseline!r}; it must be S")
        entries = tuple(_mark(document, (*keys, "cells"), row.cells[column], table.method) for column in kept)
    else:
        entries = tuple(_points(document, (*keys, "cells"), row.cells[column], table.scale) for column in kept)
    return Row(
        criterion=name,
        entries=entries,
        place=document.place(keys),
        weight=weight,
        products=tuple(row.products[column] for column in kept) if row.products else (),
        kind=row.kind,
        baseline_has=row.baseline_has,
        follows_rating=name in table.follows_rating,
        note=row.note,
    )


def _mark(document: Document, keys: Keys, entry: Entry | None, method: Method) -> Entry:
    shown: Entry | None = UNKNOWN if entry is None else "0" if entry == 0 else entry
    if method is Method.PUGH or (isinstance(shown, str) and len(shown) == 1):
        shown = shown if shown in _MARKS[method] else pugh_mark(shown)
    if shown is None or shown not in _MARKS[method]:
        _fail(document, keys, f"{entry!r} is no mark of this table; write one of {' '.join(_MARKS[method])}")
    return shown or UNKNOWN


def _points(document: Document, keys: Keys, entry: Entry | None, scale: ScaleText) -> Entry:
    if entry is None or entry == UNKNOWN:
        return UNKNOWN
    points = number_of(entry)
    if points is None:
        raise InputError(f"{document.place(keys)}: {entry!r} is no number; write points, or ? where they are unknown")
    if not scale.min <= points <= scale.max:
        _fail(
            document, keys, f"{points:g} points are outside the scale {scale.min:g}..{scale.max:g}; correct one of them"
        )
    return points


def _profile(document: Document, keys: Keys, table: _Table) -> Profile:
    try:
        return Profile(
            name=f"{table.name}, {table.scale.min:g}-{table.scale.max:g}", p_min=table.scale.min, p_max=table.scale.max
        )
    except InputError as error:
        _fail(document, (*keys, "scale"), str(error))
        raise


def _checked_weights(document: Document, keys: Keys, table: _Table) -> dict[str, float | None]:
    """Return the weight of each row, with ``20 %`` as 0.2; a Pugh table may have none, but not some."""
    weights = {name: _weight(document, (*keys, "rows", name, "weight"), row) for name, row in table.rows.items()}
    known = [weight for weight in weights.values() if weight is not None]
    for name, weight in weights.items():
        if weight is None and (known or table.method is Method.KESSELRING):
            _fail(document, (*keys, "rows", name), "the weight is missing; add weight:")
    if not any(known) and (known or table.method is Method.KESSELRING):
        _fail(document, (*keys, "rows"), "all weights are 0; give at least one criterion a positive weight")
    percent = [name for name, row in table.rows.items() if isinstance(row.weight, str) and "%" in row.weight]
    plain = [name for name, weight in weights.items() if weight is not None and weight > 1 and name not in percent]
    if percent and plain:
        _fail(document, (*keys, "rows", plain[0], "weight"), f"{table.rows[plain[0]].weight!r} may be per cent, as "
              f"{table.rows[percent[0]].weight!r} of {percent[0]!r} is; write all weights in one way")  # fmt: skip
    return weights


def _weight(document: Document, keys: Keys, row: _Row) -> float | None:
    if row.weight is None:
        return None
    found = weight_of(row.weight)
    if found is None or may_be_thousands(row.weight):
        _fail(document, keys, f"{row.weight!r} is no clear number; write 20 %, 0.2 or 20")
    elif found[0] < 0:
        _fail(document, keys, f"the weight {found[0]:g} must be at least 0; turn the criterion round")
    return found[0] if found else None


def _refuse_twice(document: Document, keys: Keys, names: Sequence[str], *, what: str) -> None:
    for place, name in enumerate(names):
        if name in names[:place]:
            _fail(document, (*keys, place), f"the {what} {name!r} occurs twice; give each a different name")


def _fail(document: Document, keys: Keys, problem: str) -> None:
    raise InputError(f"{document.place(keys)}: {problem}")
