"""The rows of a text file: separator and columns that stay the same over the most lines."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from torquerig.recordings.files.text_tables.cells import form_of, is_missing, split_cells
from torquerig.recordings.files.text_tables.lines import TextLine
from torquerig.recordings.files.text_tables.stamp_parts import is_stamp

# in this order where several fit equally: a blank may also be inside a cell, a comma may be the decimal sign
SEPARATORS = "\t;|, "
# share of the best candidate's rows with which an earlier separator is preferred
_AS_GOOD = 0.9
# characters and cells of the longest row; what is longer is no row of a table
_LONGEST_ROW, _MOST_CELLS = 2**16, 4096
# rows above those with a first number: a range, a factor, an offset [1]
_MOST_ABOVE = 4
_DIRECTIVE = re.compile(r'^"?sep=(.)"?$', re.IGNORECASE)

NUMBER, STAMP, WORDS, EMPTY = "number", "stamp", "words", "empty"


@dataclass(frozen=True, kw_only=True)
class Block:
    """Rows with one separator, one number of cells, and one family in each column.

    Parameters
    ----------
    separator : str
    families : tuple of str
        ``number``, ``stamp``, ``words`` or ``empty``, of each column.
    first, last : int
        The places of its first and last row among the lines.
    rows : int
        The number of lines that fit.
    share : float
        The share of numbers and time stamps among the filled cells of all rows with as many cells.
    """

    separator: str
    families: tuple[str, ...]
    first: int
    last: int
    rows: int
    share: float = 1.0

    @property
    def width(self) -> int:
        """The number of columns."""
        return len(self.families)

    def fits(self, cells: Sequence[str]) -> bool:
        """Return whether a row has the number of cells and the family of each."""
        return len(cells) == self.width and _fits([family_of(cell, self.separator) for cell in cells], self.families)


def family_of(cell: str, separator: str) -> str:
    """Return ``number``, ``stamp``, ``missing``, ``empty``, ``words``, or ``unsplit``: numbers in one cell."""
    if not cell:
        return EMPTY
    if form_of(cell):
        return NUMBER
    if is_missing(cell):
        return "missing"
    if is_stamp(cell):
        return STAMP
    return "unsplit" if _is_unsplit(cell, separator) else WORDS


def find_block(lines: Sequence[TextLine]) -> Block | None:
    """Return the largest block of rows among the lines, None where no line has a number."""
    directive = next((match[1] for line in lines[:3] if (match := _DIRECTIVE.match(line.text.strip()))), None)
    if directive is None:
        candidates = [_block(lines, separator) for separator in SEPARATORS]
    else:
        candidates = [_block(lines, directive)]
    found = [one for one in candidates if one is not None]
    most = max((one.rows * one.share for one in found), default=0.0)
    good = [one for one in found if one.rows * one.share >= _AS_GOOD * most]
    return next((one for one in good if one.width > 1), good[0] if good else None)


def is_directive(line: TextLine) -> bool:
    """Return whether a line is Excel's ``sep=;``."""
    return _DIRECTIVE.match(line.text.strip()) is not None


def _block(lines: Sequence[TextLine], separator: str) -> Block | None:
    rows: dict[int, list[str]] = {}
    for place, line in enumerate(lines):
        if len(line.text) <= _LONGEST_ROW and line.text.strip() and not line.is_comment():
            cells = split_cells(line.text, separator)
            rows[place] = [family_of(cell, separator) for cell in cells] if len(cells) <= _MOST_CELLS else []
    data = {place: row for place, row in rows.items() if _is_data(row, separator)}
    widths = Counter(len(row) for row in data.values())
    if not widths:
        return None
    width = widths.most_common(1)[0][0]
    families = tuple(_family(column) for column in zip(*(r for r in data.values() if len(r) == width), strict=True))
    first, last, count = _longest_run(_below_break(rows, width), families)
    if not count:
        return None
    # rows at the top without a first number, as ranges below the names, are none of the rows
    above = [place for place in range(first, min(first + _MOST_ABOVE, last)) if rows.get(place, [""])[0] == EMPTY]
    if families[0] in (NUMBER, STAMP) and above == list(range(first, first + len(above))):
        first, count = first + len(above), count - len(above)
    filled = Counter(cell for row in data.values() if len(row) == width for cell in row if cell != EMPTY)
    share = 1 - filled[WORDS] / filled.total()
    return Block(separator=separator, families=families, first=first, last=last, rows=count, share=share)


def _is_data(row: Sequence[str], separator: str) -> bool:
    if "unsplit" in row or (separator == " " and 2 * row.count(WORDS) >= len(row)):
        return False  # a sentence with a number in it is no row of words between blanks
    return NUMBER in row or STAMP in row


def _family(column: Sequence[str]) -> str:
    count = Counter(column)
    if count[NUMBER] and count[NUMBER] >= count[STAMP] + count[WORDS]:
        return NUMBER
    if count[STAMP] and count[STAMP] >= count[WORDS]:
        return STAMP
    return WORDS if count[WORDS] or count[NUMBER] else EMPTY


def _fits(row: Sequence[str], families: Sequence[str]) -> bool:
    if len(row) != len(families) or all(one in (EMPTY, WORDS) for one in row):
        return False
    return all(
        family in (WORDS, EMPTY) or one in (family, "missing", EMPTY) for one, family in zip(row, families, strict=True)
    )


def _longest_run(rows: dict[int, list[str]], families: Sequence[str]) -> tuple[int, int, int]:
    """Return the first and last line of the longest run of fitting rows, and their number.

    One row between that has a number and does not fit is a faulty row, and the run goes on.
    """
    runs: list[list[int]] = []
    between: list[list[str]] = []
    for place, row in rows.items():
        if not _fits(row, families):
            between.append(row)
            continue
        goes_on = runs and (not between or (len(between) == 1 and NUMBER in between[0]))
        runs = runs if goes_on else [*runs, []]
        runs[-1].append(place)
        between = []
    best = max(runs, key=len, default=[])
    return (best[0], best[-1], len(best)) if best else (0, 0, 0)


def _below_break(rows: dict[int, list[str]], width: int) -> dict[int, list[str]]:
    """Return the rows below the last break at which a column is empty for good that was filled above it.

    A break is a line between the rows that is none of them. Above it are entries with a key, as of oscilloscopes, and
    fewer rows than below it; below it there may also be the figures of a whole run.
    """
    whole = {place: [cell == EMPTY for cell in row] for place, row in rows.items() if len(row) == width}
    places = list(whole)
    emptied = np.array(list(whole.values()), dtype=bool).reshape(len(places), width)
    if not places:
        return rows
    all_below = np.logical_and.accumulate(emptied[::-1])[::-1]
    all_above = np.logical_and.accumulate(~emptied)
    emptied_at = [number for number in range(1, len(places)) if np.any(all_below[number] & all_above[number - 1])]
    breaks = [
        places[number] for number in emptied_at
        if places[number] > places[number - 1] + 1 and 2 * number <= len(places)
    ]  # fmt: skip
    return {place: row for place, row in rows.items() if place >= breaks[-1]} if breaks else rows


def _is_unsplit(cell: str, separator: str) -> bool:
    for other in SEPARATORS:
        if other != separator and other in cell:
            parts = [part.strip() for part in cell.split(other)]
            filled = [part for part in parts if part]
            if len(filled) > 1 and all(form_of(part) or is_stamp(part) for part in filled):
                return True
    return False
