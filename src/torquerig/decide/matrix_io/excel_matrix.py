"""A matrix read from an Excel workbook: the same checks as for YAML, with cells as places."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import yaml

from torquerig.decide.criterion import YES_NO
from torquerig.decide.matrix_io import excel_layout as layout
from torquerig.decide.matrix_io.workbook_tables import SheetTable, needed_table, refuse_unknown, sheet_tables
from torquerig.document import Document, give_notice
from torquerig.errors import InputError, did_you_mean
from torquerig.safe_workbook import read_workbook

Keys = tuple[str | int, ...]


@dataclass(frozen=True)
class ExcelDocument(Document):
    """A workbook that has been read: its data as a matrix file has them, and the cell of every entry."""

    cells: Mapping[Keys, str] = field(default_factory=dict)

    def place(self, keys: Iterable[str | int] = ()) -> str:
        """Return ``file: sheet 'Criteria', cell D4`` for the entry, or for the nearest entry around it."""
        near = tuple(keys)
        while near and near not in self.cells:
            near = near[:-1]
        return f"{self.path}: {self.cells[near]}" if near in self.cells else str(self.path)


def has_own_form(path: Path) -> bool:
    """Return whether a workbook has the sheets that the program writes, perhaps without one of them.

    Raises
    ------
    InputError
        As :func:`~torquerig.safe_workbook.read_workbook`.
    """
    found = {*read_workbook(path, (layout.SETTINGS, layout.CRITERIA, layout.FACTS, layout.SOURCES))}
    return len(found & {layout.SETTINGS, layout.CRITERIA, layout.FACTS}) > 1


def read_excel_matrix(path: Path) -> ExcelDocument:
    """Read the sheets that a person fills in; the calculated sheets are ignored.

    A formula among the entries counts with the value that the spreadsheet program stored with it. Aliases and the
    history of a matrix are in YAML only.

    Raises
    ------
    InputError
        Where the file is missing or no workbook, a sheet or a needed column is missing, a head is unknown, a name
        occurs twice, or a formula has no stored value.
    """
    book = sheet_tables(path, (layout.SETTINGS, layout.CRITERIA, layout.FACTS, layout.SOURCES))
    cells: dict[Keys, str] = {}
    data: dict[str, Any] = {}
    if layout.CRITERIA in book:
        book[layout.CRITERIA] = _with_new_heads(path, book[layout.CRITERIA])
    if layout.SETTINGS in book:
        _settings(path, book[layout.SETTINGS], data, cells)
    data["criteria"] = _criteria(path, needed_table(path, book, layout.CRITERIA, layout.NEEDED_OF_CRITERIA), cells)
    facts = needed_table(path, book, layout.FACTS, (layout.FACT_HEAD, *data["criteria"]))
    data["alternatives"] = _facts(path, facts, data["criteria"], cells)
    if layout.SOURCES in book:
        _sources(path, needed_table(path, book, layout.SOURCES, layout.NEEDED_OF_SOURCES), data, cells)
    return ExcelDocument(path, data, yaml.ScalarNode("", ""), cells)


def _settings(path: Path, table: SheetTable, data: dict[str, Any], cells: dict[Keys, str]) -> None:
    targets: dict[str, tuple[str, ...]] = {
        "name": ("name",), "baseline": ("baseline",), "scale min": ("scale", "min"), "scale max": ("scale", "max"),
        "goal": ("goal", "name"), "goal words": ("goal", "words"), "draws": ("draws",), "seed": ("seed",),
        "uncertainty scores": ("uncertainty", "scores"), "uncertainty weights": ("uncertainty", "weights"),
        "cost criterion": ("cost", "criterion"), "permissible cost": ("cost", "permissible"),
    }  # fmt: skip
    used: dict[str, str] = {}
    for number, row in table.rows:
        key, value = str(row[0] or "").strip(), row[1] if len(row) > 1 else None
        if not key or value in (None, ""):
            continue
        if key in layout.OLD_NAMES:
            used[key] = layout.OLD_NAMES[key]
            key = used[key]
        if key not in targets:
            raise InputError(f"{path}: sheet {table.name!r}, cell A{number}: unknown setting; "
                             f"{did_you_mean(key, targets)}")  # fmt: skip
        keys = targets[key]
        held: Any = _text(value) if key in ("name", "baseline", "goal", "cost criterion") else _plain(value)
        held = [word.strip() for word in str(value).split(",")] if key == "goal words" else held
        cells[keys] = f"sheet {table.name!r}, cell B{number}"
        if len(keys) == 1:
            data[keys[0]] = held
        else:
            data.setdefault(keys[0], {})[keys[1]] = held
            cells.setdefault(keys[:1], cells[keys])
    give_notice(f"{path}: sheet {table.name!r}", used)


def _with_new_heads(path: Path, table: SheetTable) -> SheetTable:
    """Return the table with the heads of earlier versions under their new names."""
    used = {old: new for old, new in layout.OLD_NAMES.items() if old in table.heads and new not in table.heads}
    give_notice(f"{path}: sheet {table.name!r}", used)
    return replace(table, heads={used.get(head, head): column for head, column in table.heads.items()})


def _criteria(path: Path, table: SheetTable, cells: dict[Keys, str]) -> dict[str, Any]:
    known = {*layout.CRITERION_HEADS}
    knots = [number for number in range(1, 100) if layout.KNOT.format(number) in table.heads]
    known |= {text.format(number) for number in knots for text in (layout.KNOT, layout.POINTS)}
    refuse_unknown(path, table, known)
    criteria: dict[str, Any] = {}
    for number, held in table.records():
        name = _name(f"{path}: {table.cell(number, 'criterion')}", held, "criterion", criteria)
        criteria[name] = _criterion(held, knots)
        cells[("criteria", name)] = table.cell(number, "criterion")
        for key, head in (("weight", "weight"), ("better", "better"), ("kind", "kind"), ("unit", "unit")):
            cells[("criteria", name, key)] = table.cell(number, head)
        cells[("criteria", name, "points")] = table.cell(number, layout.KNOT.format(1))
    return criteria


def _criterion(held: Mapping[str, Any], knots: Iterable[int]) -> dict[str, Any]:
    entry: dict[str, Any] = {key: _plain(held[key]) for key in ("better", "weight", "kind", "purpose") if key in held}
    entry |= {key: str(entry[key]) for key in ("purpose",) if key in entry}
    entry["unit"] = _text(held.get("unit", "1"))
    requirement = {"min": "requirement min", "max": "requirement max", "in_question": "in question"}
    same = {"absolute": "same within", "relative": "same within share"}
    for key, heads in (("requirement", requirement), ("indifference", same)):
        part = {name: _plain(held[head]) for name, head in heads.items() if head in held}
        if part:
            entry[key] = part
    if "band low" in held or "band high" in held:
        entry["band"] = [_plain(held.get("band low")), _plain(held.get("band high"))]
    pairs = [(held.get(layout.KNOT.format(one)), held.get(layout.POINTS.format(one))) for one in knots]
    points = [[_plain(value), _plain(got)] for value, got in pairs if value is not None or got is not None]
    return {**entry, "points": points} if points else entry


def _facts(path: Path, table: SheetTable, criteria: Mapping[str, Any], cells: dict[Keys, str]) -> dict[str, Any]:
    known = {layout.FACT_HEAD, *criteria}
    known |= {text.format(name) for name in criteria for text in (layout.LOW, layout.HIGH)}
    refuse_unknown(path, table, known)
    alternatives: dict[str, Any] = {}
    for number, held in table.records():
        where = table.cell(number, layout.FACT_HEAD)
        alternative = _name(f"{path}: {where}", held, layout.FACT_HEAD, alternatives)
        entry: dict[str, Any] = {}
        for name, criterion in criteria.items():
            place = ("alternatives", alternative, name)
            cells[place] = table.cell(number, name)
            low, high = (held.get(text.format(name)) for text in (layout.LOW, layout.HIGH))
            entry[name] = _fact(held.get(name, "?"), low, high, unit=criterion["unit"])
        alternatives[alternative] = entry
        cells["alternatives", alternative] = where
    return alternatives


def _fact(value: Any, low: Any, high: Any, *, unit: str) -> Any:
    """Return a cell as a matrix file has it: a number, an interval, text, ``?`` or a mapping."""
    if unit == YES_NO and isinstance(value, bool):
        value = "yes" if value else "no"
    if isinstance(value, str) and ".." in value and low is None and high is None:
        low, _, high = (part.strip() for part in value.partition(".."))
        low, high, value = _number_or_text(low), _number_or_text(high), "?"
    if low is None and high is None:
        return _plain(value)
    return {key: _plain(one) for key, one in (("value", value), ("low", low), ("high", high)) if one not in (None, "?")}


def _sources(path: Path, table: SheetTable, data: dict[str, Any], cells: dict[Keys, str]) -> None:
    refuse_unknown(path, table, {*layout.SOURCE_HEADS})
    keys = {"missing": "unknown_reason", "source": "source", "evidence": "evidence", "note": "note", "fact": "fact",
            "metric": "metric"}  # fmt: skip
    hand = {"by hand value": "value", "by hand points": "points", "reason": "reason"}
    for number, held in table.records():
        alternative, criterion = (_text(held.get(key, "")) for key in layout.NEEDED_OF_SOURCES)
        for name, known, head in (
            (alternative, data["alternatives"], "alternative"), (criterion, data["criteria"], "criterion"),
        ):  # fmt: skip
            if name not in known:
                raise InputError(f"{path}: {table.cell(number, head)}: unknown {head} {name!r}; "
                                 f"{did_you_mean(name, known)}")  # fmt: skip
        entry = data["alternatives"][alternative][criterion]
        full = entry if isinstance(entry, dict) else {} if entry == "?" else {"value": entry}
        full |= {key: _text(held[head]) for head, key in keys.items() if head in held}
        if "origins" in held:
            full["origins"] = [_origin(text) for text in str(held["origins"]).split(layout.NEXT)]
        by_hand = {key: _plain(held[head]) for head, key in hand.items() if head in held}
        place: Keys = ("alternatives", alternative, criterion)
        if by_hand:
            full["by_hand"] = {**by_hand, **({"reason": _text(by_hand["reason"])} if "reason" in by_hand else {})}
            cells[(*place, "by_hand")] = table.cell(number, "reason")
            for head in ("by hand points", "by hand value"):
                cells[(*place, "by_hand", hand[head])] = table.cell(number, head)
        data["alternatives"][alternative][criterion] = full or "?"


def _name(where: str, held: Mapping[str, Any], head: str, seen: Mapping[str, Any]) -> str:
    if head not in held:
        raise InputError(f"{where}: the {head} has no name; write one, or clear the row")
    name = _text(held[head])
    if name in seen:
        raise InputError(f"{where}: the {head} {name!r} occurs twice; keep one of them")
    return name


def _origin(text: str) -> dict[str, str]:
    keys = ("name", "shown", "evidence", "source")
    return dict(zip(keys, (part.strip() for part in text.split(layout.WITHIN.strip())), strict=False))


def _text(value: Any) -> str:
    """Return a name as text; a number in a cell is written as a person would."""
    return f"{value:g}" if isinstance(value, float) else str(value).strip()


def _plain(value: Any) -> Any:
    """Return text without blanks around it, and whole floats as they are read by every program."""
    return value.strip() if isinstance(value, str) else value


def _number_or_text(text: str) -> Any:
    try:
        return float(text)
    except ValueError:
        return text
