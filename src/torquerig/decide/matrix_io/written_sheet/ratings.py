"""The marks or points of a sheet, its method, its datum and its points scale."""

from __future__ import annotations

import re
from dataclasses import replace

from torquerig.decide.kesselring import Profile
from torquerig.decide.matrix_io.matrix_table import UNKNOWN, Method
from torquerig.decide.matrix_io.written_sheet.grid import Grid
from torquerig.decide.matrix_io.written_sheet.lines import Lines
from torquerig.decide.matrix_io.written_sheet.weights import MOST_POINTS
from torquerig.decide.matrix_io.written_sheet.words import Word, word_of
from torquerig.decide.matrix_io.written_values import LEVELS, LONG_DASHES, number_of, pugh_mark
from torquerig.errors import InputError

_SCALE = re.compile(
    r"\b(?:scale|skala|points?|punkte?|punkteskala|rating scale|bewertungsskala)\b[^0-9]{0,20}(\d+(?:[.,]\d+)?)\s*"
    r"(?:-|\u2013|\u2212|to|bis|\.\.+|\u2026)\s*(\d+(?:[.,]\d+)?)",
    re.IGNORECASE,
)


def method_of(lines: Lines) -> tuple[Method, Lines]:
    """Return the method, and the lines with the datum of a Pugh matrix apart, or among the rated ones for Kesselring.

    Marks, minus signs and a datum of zeros make a Pugh matrix; numbers from 0 upwards make a Kesselring matrix.

    Raises
    ------
    InputError
        Where numbers may be both.
    """
    grid, spots = lines.grid, _spots(lines, lines.rated)
    marks = [spot for spot in spots if _is_mark(grid.cells.get(spot))]
    datum = () if lines.datum is None else _spots(lines, (lines.datum,))
    numbers = {number for spot in spots if (number := number_of(grid.cells.get(spot))) is not None}
    zero = {pugh_mark(grid.cells.get(spot)) for spot in datum if spot in grid.cells} <= {"S", None}
    named_zero = lines.datum is not None and zero
    only_zero = [c for c in lines.rated if {number_of(grid.cells.get(s)) for s in _spots(lines, (c,))} == {0.0}]
    if not marks and not named_zero and only_zero and numbers <= {0.0, 1.0, 2.0}:
        raise InputError(
            f"{grid.origin}: the numbers 0 to 2 may be points, or Pugh marks with {lines.names[only_zero[0]]!r} as "
            "datum; add '(datum)' to its name, or write S for 0 and + for 1, or use points on a scale from 1"
        )
    if marks or (named_zero and numbers <= {0.0, 1.0, 2.0}):
        return Method.PUGH, _with_datum(lines)
    if named_zero and datum:
        raise InputError(
            f"{grid.origin}: {lines.names[lines.datum or 0]!r} is named as datum and has no points, but other values "
            f"reach {max(numbers, default=0):g}; write marks from -2 to 2 for a Pugh matrix, or points for it too"
        )
    return Method.KESSELRING, replace(lines, rated=_with(lines, lines.datum), datum=None)


def marks_of(lines: Lines) -> dict[tuple[int, int], str]:
    """Return the Pugh marks by cell, ``?`` where a cell is empty.

    Raises
    ------
    InputError
        For what is no mark, a datum that is not S, and a long dash that may be one minus or two.
    """
    grid = lines.grid
    found: dict[tuple[int, int], str] = {}
    everything = _spots(lines, lines.rated)
    example = next((spot for spot in everything if _is_mark(grid.cells.get(spot))), None)
    for spot in everything:
        cell = grid.cells.get(spot)
        mark = UNKNOWN if cell is None else pugh_mark(cell)
        if mark is None:
            also = f"; {grid.name(*example)} has the Pugh mark {grid.text(*example)!r}" if example else ""
            raise InputError(
                f"{grid.place(*spot)}: {str(cell)[:40]!r} is no Pugh mark; write ++ + S - -- or -2 to 2, or ? where it "
                f"is unknown{also}"
            )
        found[spot] = mark
    _refuse_long_dash(grid, found)
    for spot in () if lines.datum is None else _spots(lines, (lines.datum,)):
        cell = grid.cells.get(spot)
        is_letter = isinstance(cell, str) and (len(cell.strip()) == 1 or word_of(cell) is Word.DATUM)
        if cell is not None and pugh_mark(cell) != "S" and not (is_letter and pugh_mark(cell) is None):
            raise InputError(
                f"{grid.place(*spot)}: the datum {lines.names[spot[1]]!r} has {str(cell)[:40]!r}; it is compared with "
                "itself and must be S; correct the cell, or rename the column if it is not the datum"
            )
    return found


def points_of_cells(lines: Lines, profile: Profile) -> dict[tuple[int, int], float | str]:
    """Return the points by cell, ``?`` where a cell is empty; InputError for what is outside the scale."""
    grid = lines.grid
    found: dict[tuple[int, int], float | str] = {}
    for spot in _spots(lines, lines.rated):
        cell = grid.cells.get(spot)
        points = number_of(cell)
        if cell is None or (isinstance(cell, str) and cell.strip() == UNKNOWN):
            if not profile.stated:
                raise InputError(
                    f"{grid.place(*spot)}: the points are unknown, and the sheet states no scale, so that they may be "
                    "anything; write the points, or add a cell such as 'scale 0 to 4'"
                )
            found[spot] = UNKNOWN
        elif points is None:
            raise InputError(f"{grid.place(*spot)}: {str(cell)[:40]!r} is no number; write points, or ? if unknown")
        elif not profile.p_min <= points <= profile.p_max:
            raise InputError(
                f"{grid.place(*spot)}: {points:g} points are outside the scale {profile.p_min:g}..{profile.p_max:g}; "
                "correct them, or state the scale in a cell such as 'scale 0 to 20'; a line that is no alternative "
                "belongs on another sheet"
            )
        else:
            found[spot] = points
    return found


def profile_of(lines: Lines) -> Profile:
    """Return the points scale that the sheet states, or the unstated range of its points, at most 0 to 10.

    Raises
    ------
    InputError
        Where two scales are stated, or the ideal has different points.
    """
    grid = lines.grid
    rows = grid.turned() if grid.is_turned else grid
    texts = [" ".join(rows.text(row, c) for c in rows.columns if (row, c) in rows.cells) for row in rows.rows]
    stated = {tuple(float(end.replace(",", ".")) for end in pair) for text in texts for pair in _SCALE.findall(text)}
    if len(stated) > 1:
        raise InputError(f"{grid.origin}: states the points scales {sorted(stated)}; keep one of them")
    ideal = set() if lines.ideal is None else {number_of(grid.cells.get(s)) for s in _spots(lines, (lines.ideal,))}
    if stated:
        low, high = next(iter(stated))
        if not low < high:
            raise InputError(
                f"{grid.origin}: the points scale {low:g} to {high:g} must run upwards; write {high:g} to {low:g}"
            )
        return Profile(name=f"{low:g}-{high:g}", p_min=low, p_max=high)
    points = [p for spot in _spots(lines, lines.rated) if (p := number_of(grid.cells.get(spot))) is not None]
    low = min([1.0, *points])
    top = next(iter(ideal)) if len(ideal) == 1 else None
    if ideal and (top is None or top <= low):
        raise InputError(
            f"{grid.place(next(iter(lines.criteria)), lines.ideal or 0)}: the ideal must have the highest points of "
            "the scale for every criterion; correct it, or rename the column"
        )
    if top is not None:
        return Profile(name=f"up to {top:g}", p_min=min(0.0, low), p_max=top)
    return Profile(name="not stated", p_min=0, p_max=MOST_POINTS, stated=False)


def _with(lines: Lines, column: int | None) -> tuple[int, ...]:
    return lines.rated if column is None else tuple(sorted({*lines.rated, column}))


def _with_datum(lines: Lines) -> Lines:
    """Return the lines with the datum apart: the named one, else the only column that has S in every cell."""
    rated = _with(lines, lines.ideal)
    if lines.datum is not None:
        return replace(lines, rated=rated, ideal=None)
    grid = lines.grid
    same = [c for c in rated if {pugh_mark(grid.cells.get(spot)) for spot in _spots(lines, (c,))} == {"S"}]
    if len(same) > 1:
        named = " or ".join(repr(lines.names[column]) for column in same)
        raise InputError(
            f"{grid.origin}: the datum may be {named}, which have S only; add '(datum)' to the name of one"
        )
    return replace(lines, rated=tuple(c for c in rated if c not in same), datum=same[0] if same else None, ideal=None)


def _refuse_long_dash(grid: Grid, marks: dict[tuple[int, int], str]) -> None:
    texts = {spot: str(grid.cells.get(spot, "")).strip() for spot in marks}
    long = [spot for spot, text in texts.items() if text and text in LONG_DASHES]
    short = [spot for spot, mark in marks.items() if mark == "-" and spot not in long]
    doubled = "++" in marks.values() and "--" not in marks.values()
    if long and (short or doubled):
        raise InputError(
            f"{grid.place(*long[0])}: the long dash {texts[long[0]]!r} may be - or --, which some programs replace by "
            "it; write -1 or -2"
        )


def _is_mark(cell: object) -> bool:
    if isinstance(cell, str) and cell.strip() == UNKNOWN:
        return False
    number = number_of(cell)
    if number is None:
        return pugh_mark(cell) in LEVELS
    return number < 0 or (isinstance(cell, str) and cell.strip()[:1] in ("+", "\uff0b"))


def _spots(lines: Lines, columns: tuple[int, ...]) -> list[tuple[int, int]]:
    return [(row, column) for row in lines.criteria for column in columns]
