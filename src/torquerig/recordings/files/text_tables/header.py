"""The rows above a table: names of the columns and their units."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.recordings.files.text_tables.block import EMPTY, NUMBER, STAMP, WORDS, Block, family_of, is_directive
from torquerig.recordings.files.text_tables.cells import form_of, split_cells
from torquerig.recordings.files.text_tables.lines import TextLine
from torquerig.recordings.files.text_tables.preamble import read_preamble
from torquerig.recordings.names.channel_units import known_unit
from torquerig.recordings.names.header import split_header
from torquerig.recordings.names.time_column import time_column
from torquerig.recordings.names.words import quantity_by_words

# names, units and one or two rows of types or remarks; more lines above the table are a preamble
_ROWS = 5
_BRACKETED = re.compile(r"^[\[(<{].*[\])>}]$")


@dataclass(frozen=True, kw_only=True)
class Header:
    """The names (empty where there are none) and units of the columns as written, and the lines they stand in."""

    names: tuple[str, ...] = ()
    units: tuple[str, ...] = ()
    names_line: int = 0
    units_line: int = 0
    above: tuple[TextLine, ...] = ()
    wrong: TextLine | None = None
    """The line right above the rows, where it has a number of names that does not fit."""
    between: tuple[TextLine, ...] = ()
    """Lines of numbers between names and rows: ranges, factors, with a label in place of the time or without."""


def read_header(lines: Sequence[TextLine], block: Block) -> Header:
    """Return the header of the block: the row of words next to it with as many cells, and a row of units next to that.

    A comment line serves where no other does and one of its cells is a known name or has a known unit.
    """
    rows: list[tuple[TextLine, list[str]]] = []
    between: list[TextLine] = []
    place = block.first
    while place > 0 and len(rows) < _ROWS:
        place -= 1
        line = lines[place]
        if not line.text.strip() or is_directive(line):
            if rows or is_directive(line):
                break
            continue
        if _is_remark(line, block):
            continue
        cells = _cells(line.text, block)
        if read_preamble([line]).notes:
            break
        if cells is None:
            if rows or len(between) == _ROWS or not _is_between(line, block):
                break
            between.append(line)
            continue
        rows.append((line, cells))
    if not rows or (between and not any(_has_known(cells) for _, cells in rows)):
        return _from_comment(lines[: block.first], block)
    units_at = next((number for number, (_, cells) in enumerate(rows[:3]) if len(rows) > 1 and _are_units(cells)), None)
    names_at = 0 if units_at is None else (units_at + 1 if units_at + 1 < len(rows) else units_at - 1)
    line, names = rows[names_at]
    above = tuple(one for one in lines[: block.first] if one.number < line.number and not is_directive(one))
    units = () if units_at is None else tuple(_unbracketed(cell) for cell in rows[units_at][1])
    return Header(
        names=tuple(names), names_line=line.number, above=above, units=units,
        units_line=0 if units_at is None else rows[units_at][0].number, between=tuple(reversed(between)),
    )  # fmt: skip


def _is_between(line: TextLine, block: Block) -> bool:
    """Return whether a line has numbers below the names of signals, and a label or nothing where rows have a time."""
    families = [family_of(cell, block.separator) for cell in split_cells(line.text, block.separator)]
    return (
        block.families[0] in (NUMBER, STAMP)
        and 1 < len(families) <= block.width
        and families[0] in (WORDS, EMPTY)
        and NUMBER in families
        and set(families[1:]) <= {NUMBER, EMPTY, "missing"}
    )


def _from_comment(lines: Sequence[TextLine], block: Block) -> Header:
    filled = [line for line in lines if line.text.strip() and not is_directive(line)]
    above = tuple(filled)
    if not filled:
        return Header()
    last = filled[-1]
    if not _is_remark(last, block):
        cells = split_cells(last.text, block.separator)
        is_wrong = len(cells) > 1 and any(_is_known(cell) for cell in cells) and not read_preamble([last]).notes
        return Header(above=above, wrong=last if is_wrong else None)
    rows = [(line, _commented(line, block)) for line in filled[-2:]]
    last_cells = rows[-1][1]
    if len(rows) > 1 and last_cells and _are_units(last_cells) and _has_known(rows[0][1]):
        units = tuple(_unbracketed(cell) for cell in last_cells)
        return Header(names=tuple(rows[0][1] or ()), names_line=rows[0][0].number, units=units,
                      units_line=last.number, above=above[:-2])  # fmt: skip
    if not _has_known(last_cells):
        return Header(above=above)
    return Header(names=tuple(last_cells or ()), names_line=last.number, above=above[:-1])


def _is_remark(line: TextLine, block: Block) -> bool:
    return line.is_comment() or (block.separator != ";" and line.text.lstrip().startswith(";"))


def _commented(line: TextLine, block: Block) -> list[str] | None:
    if not line.is_comment():
        return None
    return _cells(line.text.strip().strip('"').lstrip("#%/").strip(" "), block)


def _has_known(cells: Sequence[str] | None) -> bool:
    return cells is not None and any(_is_known(cell) for cell in cells)


def _cells(text: str, block: Block) -> list[str] | None:
    """Return a header row's cells, one for each column; None where the line cannot be one."""
    cells = split_cells(text, block.separator)
    if block.separator == " " and len(cells) != block.width:
        # names with blanks in them are two blanks or a tab apart, or another sign separates the names
        for pattern in (r"\s{2,}", r"\t", r"\s*[,;|]\s*"):
            parts = re.split(pattern, text.strip())
            if len(parts) == block.width:
                cells = [part.strip().strip('"') for part in parts]
                break
    if len(cells) == block.width - 1:
        pairs = (place for place in range(block.width - 1) if block.families[place : place + 2] == (STAMP, STAMP))
        date = next(pairs, -1)
        cells = [*cells[:date], "", *cells[date:]] if date >= 0 else cells  # one name for a date and its time of day
    while len(cells) > block.width and not cells[-1]:
        cells.pop()
    optional = next((n for n, family in enumerate(reversed(block.families)) if family in (NUMBER, STAMP)), 0)
    if not block.width - optional <= len(cells) <= block.width or not any(cells):
        return None
    if block.width == 1 and re.search(r"[:=]\s*\S", text):
        return None
    cells += [""] * (block.width - len(cells))
    families = [family_of(cell, block.separator) for cell in cells]
    numbers = sum(family in (NUMBER, STAMP) for family in families)
    # channels may be called 1, 2, 3 behind a known name
    numbered = any(_is_known(cell) for cell in cells) and all(cell.isdigit() for cell in cells if form_of(cell))
    if 2 * numbers > sum(bool(cell) for cell in cells) and not numbered:
        return None
    return [cell.rstrip(":").rstrip() for cell in cells]


def _are_units(cells: Sequence[str]) -> bool:
    """Return whether half of the filled cells or more are units, and none is known as a name."""
    filled = [cell for cell in cells if cell]
    known = sum(known_unit(_unbracketed(cell)) is not None or _BRACKETED.match(cell) is not None for cell in filled)
    names = sum(not _BRACKETED.match(cell) and _is_name(cell) for cell in filled)
    return bool(filled) and 2 * known >= len(filled) and names == 0


def _is_name(cell: str) -> bool:
    return known_unit(cell) is None and (quantity_by_words(cell) is not None or time_column([cell]) is not None)


def _is_known(cell: str) -> bool:
    return bool(cell) and (_is_name(cell) or split_header(cell)[1] is not None)


def _unbracketed(cell: str) -> str:
    return cell[1:-1].strip() if _BRACKETED.match(cell) else cell
