"""Whether each column of an elimination is a demand."""

from __future__ import annotations

import re

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.recompute import undeciding_rows
from torquerig.decide.matrix_io.sheet import Book, Method, Sheet

WISH = re.compile(
    r"\b(wish|wishes|wished|nice|prefer|prefers|preferred|preferably|ideally|if possible|should|desirable)\b"
)


def wish_worded_demand(sheet: Sheet, book: Book) -> list[Finding]:
    """Find demands that eliminate somebody although their own wording calls them a wish."""
    if sheet.method is not Method.ELIMINATION:
        return []
    found = []
    for row in sheet.rows:
        wish = WISH.search(f"{row.criterion} {row.purpose}".lower())
        if wish and "-" in row.entries:
            out = [name for name, entry in zip(sheet.alternatives, row.entries, strict=True) if entry == "-"]
            found.append(
                about(
                    row,
                    lint="a wish used as a demand",
                    table=sheet.name,
                    what=f"{row.criterion!r} eliminates {quoted(out)}, but is worded as a wish ({wish[0]!r})",
                    why="a wish may rank and never eliminates; what it takes out is never compared",
                    remedy="give it points and a weight instead of a demand, or state why it is one",
                )
            )
    return found


def wish_used_as_demand(sheet: Sheet, book: Book) -> list[Finding]:
    """Find columns of a printed elimination that never decide anything."""
    if sheet.method is not Method.ELIMINATION or None in sheet.passed or not sheet.passed:
        return []
    found = []
    for row in undeciding_rows(sheet):
        ignored = sum(entry == "-" and bool(yes) for entry, yes in zip(row.entries, sheet.passed, strict=True))
        what = f"{ignored} pass in spite of their -" if ignored else "nobody fails it and not everybody meets it"
        found.append(
            about(
                row,
                lint="a wish used as a demand",
                table=sheet.name,
                what=f"{row.criterion!r} never decides: {what}",
                why="a reader takes it for a demand that the winners meet",
                remedy="move it to the rated criteria, or apply it",
            )
        )
    return found
