"""Lints of eliminations: each column must be a requirement."""

from __future__ import annotations

import re

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet
from torquerig.decide.matrix_io.recompute import undeciding_rows

WISH = re.compile(
    r"\b(wish|wishes|wished|nice|prefer|prefers|preferred|preferably|ideally|if possible|should|desirable)\b"
)


def wish_worded_requirement(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find requirements that eliminate an alternative although they are worded as a wish."""
    if table.method is not Method.ELIMINATION:
        return []
    found = []
    for row in table.rows:
        wish = WISH.search(f"{row.criterion} {row.purpose}".lower())
        if wish and "-" in row.entries:
            eliminated = [name for name, entry in zip(table.alternatives, row.entries, strict=True) if entry == "-"]
            found.append(
                about(
                    row,
                    lint="a wish used as a requirement",
                    table=table.name,
                    what=f"{row.criterion!r} eliminates {quoted(eliminated)}, but is worded as a wish ({wish[0]!r})",
                    why="a wish may rank but not eliminate; an eliminated alternative is not compared",
                    remedy="give it points and a weight, or state why it is a requirement",
                )
            )
    return found


def wish_used_as_requirement(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find columns of a printed elimination that never eliminate an alternative."""
    if table.method is not Method.ELIMINATION or None in table.passed or not table.passed:
        return []
    found = []
    for row in undeciding_rows(table):
        ignored = sum(entry == "-" and bool(yes) for entry, yes in zip(row.entries, table.passed, strict=True))
        what = f"{ignored} pass although they have -" if ignored else "no alternative fails it and not all meet it"
        found.append(
            about(
                row,
                lint="a wish used as a requirement",
                table=table.name,
                what=f"{row.criterion!r} never decides: {what}",
                why="it looks like a requirement that the winners meet",
                remedy="move it to the rated criteria, or apply it",
            )
        )
    return found
