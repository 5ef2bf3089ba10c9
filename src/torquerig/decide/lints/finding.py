"""What a lint says of a table: where, what, why it matters and what to do."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.matrix_io.sheet import Row, Sheet


@dataclass(frozen=True, kw_only=True)
class Finding:
    """One thing that is wrong with a table.

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


def about(where: Sheet | Row, *, lint: str, table: str, what: str, why: str, remedy: str) -> Finding:
    """Return a finding that stands where the sheet or row stands."""
    return Finding(lint=lint, table=table, place=where.place, what=what, why=why, remedy=remedy)


def quoted(names: list[str]) -> str:
    """Return the names for a sentence: ``'a', 'b'``."""
    return ", ".join(repr(name) for name in names)
