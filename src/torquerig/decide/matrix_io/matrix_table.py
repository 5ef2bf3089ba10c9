"""Printed or calculated table of a decision: names, marks or points, and the sums and ranks below them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

from torquerig.decide.criterion import Better, Kind
from torquerig.decide.kesselring import TEACHING, Profile

UNKNOWN = "?"
SAME = ("0", "S", "s")
_SIGN = {"++": 2.0, "+": 1.0, "-": -1.0, "--": -2.0, "0": 0.0, "S": 0.0, "s": 0.0}

Entry = str | float


class Method(Enum):
    """The method of a table."""

    ELIMINATION = "elimination"
    PUGH = "pugh"
    KESSELRING = "kesselring"


@dataclass(frozen=True, kw_only=True)
class Row:
    """One criterion of a table.

    Parameters
    ----------
    criterion : str
        The name as printed.
    entries : tuple of str or float
        One per alternative: a mark as printed (``++ + - -- 0 S ? !``), points, or ``?``.
    place : str
        ``file:line: key`` of the row, for findings; empty if it was calculated.
    weight : float or None
        As printed (Kesselring, and a Pugh table that has weights).
    products : tuple of float or None
        Weight times points as printed, one per alternative; empty if none are.
    kind : Kind
        Technical or economic.
    baseline_has : bool
        The baseline has the property, so that no alternative can be better.
    follows_rating : bool
        The mark follows from the rating, so that equal ratings must get equal marks.
    better : Better or None
        Which values are wanted, where that is stated.
    purpose, note : str
    """

    criterion: str
    entries: tuple[Entry, ...]
    place: str = ""
    weight: float | None = None
    products: tuple[float | None, ...] = ()
    kind: Kind = Kind.TECHNICAL
    baseline_has: bool = False
    follows_rating: bool = False
    better: Better | None = None
    purpose: str = ""
    note: str = ""

    @property
    def numbers(self) -> tuple[float | None, ...]:
        """The entries as numbers: points, or -2 to 2 for marks; None where unknown or not tested."""
        return tuple(_SIGN.get(entry) if isinstance(entry, str) else entry for entry in self.entries)

    @property
    def varies(self) -> bool:
        """Whether at least two alternatives have different entries."""
        return len({canonical(entry) for entry in self.entries}) > 1


@dataclass(frozen=True, kw_only=True)
class MatrixTable:
    """One table.

    Parameters
    ----------
    name, title, section, place : str
    method : Method
    alternatives : tuple of str
        As printed, without the baseline and the ideal column.
    rows : tuple of Row
    baseline : str
        The reference column (Pugh).
    sums, ranks, passed : tuples, one per alternative, or empty
        What was printed under the table; ``passed`` is the decision of an elimination.
    spare_sums : tuple of float
        Printed sums that belong to no column.
    ideal_sum : float or None
        The printed sum of the ideal column.
    profile : Profile
        The points scale (Kesselring).
    reading_of : str
        The table of which this one is a proposed reading; the lints skip such a table.
    printed : str
        The table as printed in the source, where columns moved.
    note : str
    """

    name: str
    method: Method
    alternatives: tuple[str, ...]
    rows: tuple[Row, ...]
    title: str = ""
    section: str = ""
    place: str = ""
    baseline: str = ""
    sums: tuple[float | None, ...] = ()
    ranks: tuple[int | None, ...] = ()
    passed: tuple[bool | None, ...] = ()
    spare_sums: tuple[float, ...] = ()
    ideal_sum: float | None = None
    profile: Profile = TEACHING
    reading_of: str = ""
    printed: str = ""
    note: str = ""

    def column(self, alternative: str) -> tuple[Entry, ...]:
        """Return the entries of one alternative, one per row."""
        place = self.alternatives.index(alternative)
        return tuple(row.entries[place] for row in self.rows)

    @property
    def weights(self) -> tuple[float, ...]:
        """The printed weights, 0 where a row has none."""
        return tuple(row.weight or 0.0 for row in self.rows)

    @property
    def has_weights(self) -> bool:
        """Whether a row has a weight."""
        return any(row.weight is not None for row in self.rows)


@dataclass(frozen=True, kw_only=True)
class Alias:
    """Several names of one thing, the first being the one to use."""

    names: tuple[str, ...]
    reason: str = ""
    place: str = ""


@dataclass(frozen=True, kw_only=True)
class TableSet:
    """All tables of one decision, with its goal.

    Parameters
    ----------
    tables : tuple of MatrixTable
    goal : str
        The stated goal; empty if none is stated.
    goal_words : tuple of str
        A row whose name has one of these words (any case) rates the goal.
    ratings : mapping of str to str
        Rated power or the like of each alternative, as text; equal texts are equal ratings.
    aliases : tuple of Alias
    source : str
    """

    tables: tuple[MatrixTable, ...]
    goal: str = ""
    goal_words: tuple[str, ...] = ()
    ratings: Mapping[str, str] = field(default_factory=dict)
    aliases: tuple[Alias, ...] = ()
    source: str = ""

    @property
    def audited(self) -> tuple[MatrixTable, ...]:
        """The published or calculated tables, without the proposed readings."""
        return tuple(table for table in self.tables if not table.reading_of)

    def table(self, name: str) -> MatrixTable:
        """Return the table of this name."""
        return next(table for table in self.tables if table.name == name)


def canonical(entry: Entry) -> Entry:
    """Return the entry with one spelling of "same": ``0`` and ``S`` become ``S``."""
    return "S" if entry in SAME else entry
