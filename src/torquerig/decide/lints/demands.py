"""Whether each column of an elimination is a demand."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.recompute import undeciding_rows
from torquerig.decide.sheet import Book, Method, Sheet


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
