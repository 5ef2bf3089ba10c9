"""Lines below the rows of a text table: remarks, and figures of the whole run."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.recordings.files.text_tables.block import EMPTY, NUMBER, STAMP, WORDS, family_of
from torquerig.recordings.files.text_tables.cells import form_of, is_missing
from torquerig.recordings.files.text_tables.layout import Layout
from torquerig.recordings.files.text_tables.lines import is_comment
from torquerig.recordings.files.text_tables.source import decoded
from torquerig.recordings.names.time_column import time_column

# rows above a last one that are enough to see that it is cut off
_COMPARED = 20


@dataclass(frozen=True)
class Footer:
    """The numbers of its first and last line, and of a last row that is cut off; 0 where there is none."""

    first: int
    last: int
    cut: int = 0

    def note(self) -> str:
        """Return one sentence about it."""
        if self.cut:
            return f"line {self.cut} has no end and its last number is cut off; the row is not read"
        if self.first == self.last:
            return f"line {self.first} below the rows is no row and is not read"
        return f"lines {self.first} to {self.last} below the rows are no rows and are not read"


def without_footer(body: bytes, first_line: int, layout: Layout) -> tuple[bytes, Footer | None]:
    """Return the last lines of a file without the footer.

    A footer's lines have no number, begin with a word where the rows begin with a number or a time, or have no time
    where all rows have one. A last row without a line end is left out where its last number is shorter than all above
    it. Every other line is a row, and a faulty one is reported.
    """
    cut = _cut_row(body, layout)
    if cut:
        return body[: -len(cut)], Footer(0, 0, first_line + body.count(b"\n"))
    end, first, last = len(body), 0, 0
    number = first_line + body.count(b"\n", 0, max(len(body) - 1, 0))
    while end > 0:
        start = body.rfind(b"\n", 0, end - 1) + 1
        text = decoded(body[start:end])
        if text.strip(" \t\r\n\0") and not is_comment(text):
            if not _is_below(text, layout):
                break
            first, last = number, last or number
        end, number = start, number - 1
    return body[:end], Footer(first, last) if first else None


def _is_below(text: str, layout: Layout) -> bool:
    families = [family_of(cell, layout.dialect.separator) for cell in layout.dialect.cells(text)]
    if NUMBER not in families and STAMP not in families:
        return "missing" not in families or len(families) != len(layout.names)
    time = _time_place(layout)
    if time is not None and time < len(families) and families[time] in (EMPTY, "missing"):
        return True
    begins = next((family for family in layout.families if family in (NUMBER, STAMP)), NUMBER)
    return families[0] in (WORDS, "unsplit") and layout.families[0] == begins


def _time_place(layout: Layout) -> int | None:
    """Return the place of the column of times, where each of the first rows has one; the last of them may have none."""
    found = time_column(layout.of_family(NUMBER), layout.units)
    name = found.name if found is not None else next(iter(layout.of_family(STAMP)), None)
    if name is None:
        return None
    filled = [bool(cell) and not is_missing(cell) for cell in layout.column(name)]
    while filled and not filled[-1]:
        filled.pop()
    return layout.names.index(name) if filled and all(filled) else None


def _cut_row(body: bytes, layout: Layout) -> bytes:
    """Return the last line, where the file ends within it; empty where it is whole."""
    start = body.rfind(b"\n") + 1
    rows = [layout.dialect.cells(line) for line in decoded(body[:start]).split("\n") if line.strip()]
    cells = layout.dialect.cells(decoded(body[start:]))
    places = [place for place, family in enumerate(layout.families) if family in (NUMBER, STAMP)]
    if not body[start:].strip() or is_comment(decoded(body[start:])) or len(rows) < _COMPARED or not places:
        return b""
    if family_of(cells[0], layout.dialect.separator) not in (layout.families[0], "missing", EMPTY):
        return b""
    if not places[-1] < len(cells) <= len(layout.families):
        return b""  # a row with fewer or more cells is reported
    last = len(cells) - 1
    if layout.families[last] != NUMBER or form_of(cells[last]) == "":
        return b""
    above = [len(row[last].lstrip("+-")) for row in rows if len(row) > last and form_of(row[last])]
    return body[start:] if above and len(cells[last].lstrip("+-")) < min(above) else b""
