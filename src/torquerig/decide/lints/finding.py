"""Finding of a lint: the place, the error, its effect and the remedy."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.matrix_io.matrix_table import MatrixTable, Row


@dataclass(frozen=True, kw_only=True)
class Finding:
    """One error in a table.

    Parameters
    ----------
    lint : str
        The name of the check.
    table, place : str
        The table's name, and ``file:line: key`` where it was read from a file.
    what, why, remedy : str
        One sentence each.
    """

    lint: str
    table: str
    what: str
    why: str
    remedy: str
    place: str = ""


def about(where: MatrixTable | Row, *, lint: str, table: str, what: str, why: str, remedy: str) -> Finding:
    """Return a finding with the place of the table or row."""
    return Finding(lint=lint, table=table, place=where.place, what=what, why=why, remedy=remedy)


def quoted(names: list[str]) -> str:
    """Return the names for a sentence: ``'a', 'b'``."""
    return ", ".join(repr(name) for name in names)
