"""Lines below the rows of a text table: remarks, and figures of the whole run."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.recordings.files.text_tables.block import NUMBER, STAMP, WORDS, family_of
from torquerig.recordings.files.text_tables.layout import Layout
from torquerig.recordings.files.text_tables.lines import is_comment
from torquerig.recordings.files.text_tables.source import decoded


@dataclass(frozen=True)
class Footer:
    """The numbers of its first and last line."""

    first: int
    last: int

    def note(self) -> str:
        """Return one sentence about it."""
        if self.first == self.last:
            return f"line {self.first} below the rows is no row and is not read"
        return f"lines {self.first} to {self.last} below the rows are no rows and are not read"


def without_footer(body: bytes, first_line: int, layout: Layout) -> tuple[bytes, Footer | None]:
    """Return the last lines of a file without the footer.

    A footer's lines have no number, or begin with a word where the rows begin with a number or a time. Every other
    line is a row, and a faulty one is reported.
    """
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
    begins = next((family for family in layout.families if family in (NUMBER, STAMP)), NUMBER)
    return families[0] in (WORDS, "unsplit") and layout.families[0] == begins
