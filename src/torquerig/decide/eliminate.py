"""Selection chart of Pahl and Beitz: which alternatives meet the requirements; unknown values stay unknown.

``+`` meets, ``-`` fails, ``?`` the facts are missing, ``!`` the requirement itself must be checked. A row stops at its
first ``-``; later cells stay empty. Wishes are not tested here, because a wish never eliminates.
Source: Pahl, Beitz, Feldhusen, Grote, Engineering Design, 3rd ed., section 3.3.1 (selection chart).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

from torquerig.decide.criterion import YES_NO, Criterion

if TYPE_CHECKING:
    from torquerig.decide.matrix import Cell, DecisionMatrix


class Mark(StrEnum):
    """The sign in one cell of the chart."""

    MEETS = "+"
    FAILS = "-"
    UNKNOWN = "?"
    CHECK = "!"


class Decision(StrEnum):
    """What to do with one alternative."""

    PURSUE = "pursue"
    ELIMINATE = "eliminate"
    OPEN = "open"
    REVISE = "revise"


@dataclass(frozen=True, kw_only=True)
class Remark:
    """Why a cell is not ``+``: mandatory for each ``-``, ``?`` and ``!``.

    Parameters
    ----------
    criterion : str
    mark : Mark
    rule : str
        The requirement as a formula, with limit and unit.
    limit, miss : float or None
        The limit that is broken and how far the nearest possible value lies from it [unit]; None where not a number.
    value, unit, source : str
        What is known, as a table shows it, and its source.
    missing : str
        The missing fact, with ``?``; the question about the requirement, with ``!``.
    """

    criterion: str
    mark: Mark
    rule: str
    limit: float | None = None
    miss: float | None = None
    value: str = ""
    unit: str = "1"
    source: str = ""
    missing: str = ""

    def sentence(self) -> str:
        """Return the remark as one line."""
        suffix = "" if self.unit == "1" else f" {self.unit}"
        source = f" [{self.source}]" if self.source else ""
        if self.mark is Mark.UNKNOWN:
            return f"{self.mark} {self.rule}: it is {self.value}{suffix}{source}; missing: {self.missing}"
        miss = "" if self.miss is None else f", misses by {self.miss:.3g}{suffix}"
        check = f"; check the requirement: {self.missing}" if self.mark is Mark.CHECK else ""
        return f"{self.mark} {self.rule}: it is {self.value}{suffix}{miss}{source}{check}"


@dataclass(frozen=True, kw_only=True)
class ChartRow:
    """One alternative in the chart; ``marks`` ends at the first ``-``."""

    alternative: str
    marks: Mapping[str, Mark]
    remarks: tuple[Remark, ...]

    @property
    def decision(self) -> Decision:
        """The decision from the marks: ``-`` eliminates; else ``!`` requires a revision; else ``?`` leaves it open."""
        given = set(self.marks.values())
        if Mark.FAILS in given:
            return Decision.ELIMINATE
        if Mark.CHECK in given:
            return Decision.REVISE
        return Decision.OPEN if Mark.UNKNOWN in given else Decision.PURSUE

    @property
    def missing(self) -> tuple[str, ...]:
        """The facts that are needed before an open row can be decided."""
        return tuple(remark.missing for remark in self.remarks if remark.mark is Mark.UNKNOWN)


@dataclass(frozen=True, kw_only=True)
class SelectionChart:
    """The whole chart, in the order of the matrix."""

    criteria: tuple[str, ...]
    rows: tuple[ChartRow, ...]

    def with_decision(self, *decisions: Decision) -> tuple[str, ...]:
        """Return the names of the alternatives that got one of these decisions."""
        return tuple(row.alternative for row in self.rows if row.decision in decisions)


def eliminate(matrix: DecisionMatrix) -> SelectionChart:
    """Return for each alternative whether it meets the requirements, and if not by how much it misses.

    Parameters
    ----------
    matrix : DecisionMatrix
        Only criteria with a requirement are tested, in their order.

    Returns
    -------
    SelectionChart
        An interval wholly inside the limits gets ``+``, wholly outside ``-``, across a limit ``?``.
    """
    requirements = tuple(criterion for criterion in matrix.criteria if not criterion.wish)
    rows = tuple(_row(matrix, alternative, requirements) for alternative in matrix.alternatives)
    return SelectionChart(criteria=tuple(criterion.name for criterion in requirements), rows=rows)


def chart_from_marks(
    marks: Mapping[str, Sequence[Mark]], *, criteria: Sequence[str], source: str = "as printed"
) -> SelectionChart:
    """Return the chart of given marks: ``marks[alternative]`` has one per criterion; none counts after a ``-``."""
    rows = []
    for alternative, given in marks.items():
        kept = dict(zip(criteria, given, strict=True))
        stop = next((place for place, mark in enumerate(given) if mark is Mark.FAILS), len(kept))
        kept = dict(list(kept.items())[: stop + 1])
        remarks = tuple(
            Remark(
                criterion=name, mark=mark, rule=name, value=str(mark), source=source, missing=f"{name} of {alternative}"
            )
            for name, mark in kept.items()
            if mark is not Mark.MEETS
        )
        rows.append(ChartRow(alternative=alternative, marks=kept, remarks=remarks))
    return SelectionChart(criteria=tuple(criteria), rows=tuple(rows))


def _row(matrix: DecisionMatrix, alternative: str, requirements: tuple[Criterion, ...]) -> ChartRow:
    marks: dict[str, Mark] = {}
    remarks = []
    for criterion in requirements:
        mark, remark = _mark(alternative, matrix.cell(alternative, criterion.name), criterion)
        marks[criterion.name] = mark
        if remark is not None:
            remarks.append(remark)
        if mark is Mark.FAILS:
            break
    return ChartRow(alternative=alternative, marks=marks, remarks=tuple(remarks))


def _mark(alternative: str, cell: Cell, criterion: Criterion) -> tuple[Mark, Remark | None]:
    requirement = criterion.requirement
    if requirement is None:
        return Mark.MEETS, None
    low, high = cell.bounds
    below, above = requirement.low, requirement.high
    rule = requirement.rule(criterion.name, criterion.unit)
    if (below is None or low >= below) and (above is None or high <= above) and not cell.unknown:
        return Mark.MEETS, None
    limit, miss = None, None
    if below is not None and high < below:
        limit, miss = below, below - high
    elif above is not None and low > above:
        limit, miss = above, low - above
    mark = Mark.UNKNOWN if limit is None else Mark.FAILS
    if mark is Mark.FAILS and requirement.in_question:
        mark = Mark.CHECK
    missing = cell.unknown_reason or f"{criterion.name} of {alternative}"
    return mark, Remark(
        criterion=criterion.name,
        mark=mark,
        rule=rule,
        limit=limit,
        miss=None if criterion.unit == YES_NO else miss,
        value=cell.shown(),
        unit="1" if cell.unknown or cell.text else criterion.unit,
        source=cell.source,
        missing={Mark.UNKNOWN: missing, Mark.CHECK: requirement.in_question}.get(mark, ""),
    )
