"""Comparison of a computed table with the published one: cells, then sums, ranks and decisions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from torquerig.decide.criterion import Criterion
from torquerig.decide.eliminate import eliminate
from torquerig.decide.kesselring import KesselringResult, kesselring
from torquerig.decide.lints.audit import audit
from torquerig.decide.lints.finding import Finding
from torquerig.decide.lints.polarity import polarity_unclear
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.matrix_table import Entry, Method, TableSet
from torquerig.decide.matrix_io.recompute import undeciding_rows
from torquerig.decide.pugh import pugh
from torquerig.decide.ranks import shown_rank
from torquerig.metrics.figure import Figure
from torquerig.study.reference_decision.computed import ComputedTable
from torquerig.study.reference_decision.reasons import (
    Compared,
    Reason,
    points_turned,
    reason_of_points,
    reason_of_requirement,
    reason_of_sign,
    signs_of,
    turned_round,
)


@dataclass(frozen=True, kw_only=True)
class ComparedCell:
    """One cell: printed and computed mark, the figure behind it, and the reason of a difference."""

    row: str
    alternative: str
    published: str
    computed: str
    figure: Figure
    reason: Reason


@dataclass(frozen=True, kw_only=True)
class ComparedTable:
    """A published table and its computed one.

    Parameters
    ----------
    table : ComputedTable
    cells : tuple of ComparedCell
        Row by row of the published table.
    totals : mapping of str to tuple of str
        Sums, ranks and decisions, a text per published alternative.
    rated : KesselringResult or None
        With the missing weight on the goal and the added motors (Kesselring).
    findings : tuple of Finding
        The published table's errors.
    """

    table: ComputedTable
    cells: tuple[ComparedCell, ...]
    totals: Mapping[str, tuple[str, ...]]
    rated: KesselringResult | None
    findings: tuple[Finding, ...]

    @property
    def differing(self) -> tuple[ComparedCell, ...]:
        """The cells whose computed mark differs from the printed one."""
        return tuple(cell for cell in self.cells if cell.reason.sentence)


def compared_table(table: ComputedTable, book: TableSet, *, agree_within: float) -> ComparedTable:
    """Return the comparison of a computed table with the published one."""
    findings = tuple(one for one in audit(book) if one.table == table.sheet.name)
    unclear = {row.criterion for row in table.sheet.rows if _is_unclear(table, row.criterion, book)}
    if table.sheet.method is not Method.KESSELRING:
        made = _elimination if table.sheet.method is Method.ELIMINATION else _pugh
        cells, totals = made(table, unclear)
        return ComparedTable(table=table, cells=cells, totals=totals, rated=None, findings=findings)
    cells, totals, rated = _kesselring(table, unclear, agree_within)
    return ComparedTable(table=table, cells=cells, totals=totals, rated=rated, findings=findings)


Found = tuple[tuple[ComparedCell, ...], dict[str, tuple[str, ...]]]


def _elimination(table: ComputedTable, unclear: set[str]) -> Found:
    sheet, cells = table.sheet, []
    marks = _every_mark(table.matrix)
    others = _every_mark(table.otherwise) if table.otherwise else {}
    for row in sheet.rows:
        for name, said in zip(sheet.alternatives, row.entries, strict=True):
            key = name, row.criterion
            compared = _compared(table, key, said, marks[key], others.get(key, ""))
            cells.append(_cell(table, key, said, marks[key], reason_of_requirement(compared)))
    printed = {True: "Yes", False: "No", None: ""}
    undeciding = {row.criterion for row in undeciding_rows(sheet)} if None not in sheet.passed else set()
    totals = {
        "printed decision": tuple(printed[passed] for passed in sheet.passed),
        "computed, every - eliminates": _decisions(table, set()),
    }
    if 0 < len(undeciding) < len(sheet.rows):
        totals["computed, without the columns that never eliminate"] = _decisions(table, undeciding)
    return tuple(cells), totals


def _decisions(table: ComputedTable, without: set[str]) -> tuple[str, ...]:
    criteria = tuple(one for one in table.matrix.criteria if one.name not in without)
    cells = {key: cell for key, cell in table.matrix.cells.items() if key[1] not in without}
    chart = eliminate(replace(table.matrix, criteria=criteria, cells=cells))
    made = {row.alternative: str(row.decision) for row in chart.rows}
    return tuple(made[name] for name in table.sheet.alternatives)


def _pugh(table: ComputedTable, unclear: set[str]) -> Found:
    sheet, cells = table.sheet, []
    result = pugh(table.matrix, sheet.baseline)
    same = pugh(table.same_gearbox, sheet.baseline) if table.same_gearbox else result
    others = pugh(table.otherwise, sheet.baseline) if table.otherwise else None
    signs = {name: signs_of(result, name) for name in sheet.alternatives}
    for row in sheet.rows:
        column = [signs[name][row.criterion] for name in sheet.alternatives]
        criterion = _criterion(table, row.criterion)
        turned = row.criterion in unclear and turned_round(list(row.entries), column, criterion)
        for name, said in zip(sheet.alternatives, row.entries, strict=True):
            key = name, row.criterion
            other = signs_of(others, name).get(row.criterion, "") if others else ""
            compared = replace(
                _compared(table, key, said, signs[name][row.criterion], other),
                baseline=table.figures[sheet.baseline, row.criterion], polarity=turned,
                same_gearbox=signs_of(same, name)[row.criterion],
            )  # fmt: skip
            cells.append(_cell(table, key, said, signs[name][row.criterion], reason_of_sign(compared)))
    places = [result.alternatives.index(name) for name in sheet.alternatives]
    best, worst = result.rank_range
    nets = [(int(result.net_low[place]), int(result.net_high[place])) for place in places]
    return tuple(cells), {
        "printed sum": _printed(sheet.sums),
        "computed net, ? as + or -": tuple(f"{low}" if low == high else f"{low}..{high}" for low, high in nets),
        "printed rank": _printed(sheet.ranks),
        f"computed rank, {sheet.baseline} among them": tuple(
            shown_rank(int(best[place]), int(worst[place])) for place in places
        ),
    }


def _kesselring(
    table: ComputedTable, unclear: set[str], within: float
) -> tuple[tuple[ComparedCell, ...], dict[str, tuple[str, ...]], KesselringResult]:
    sheet, cells = table.sheet, []
    printed = {row.criterion for row in sheet.rows}
    result = kesselring(
        replace(
            table.matrix,
            criteria=tuple(one for one in table.matrix.criteria if one.name in printed),
            cells={key: cell for key, cell in table.matrix.cells.items() if key[1] in printed},
        ),
        profile=sheet.profile,
    )
    places = [result.alternatives.index(name) for name in sheet.alternatives]
    for row in sheet.rows:
        column = result.criteria.index(row.criterion)
        turned = row.criterion in unclear and points_turned(list(row.entries), result, column, places)
        for name, place, said in zip(sheet.alternatives, places, row.entries, strict=True):
            low, high = float(result.low[place, column]), float(result.high[place, column])
            shown = f"{low:.2g}" if high - low < 0.05 else f"{low:.2g}..{high:.2g}"
            compared = replace(_compared(table, (name, row.criterion), said, shown, ""), polarity=turned)
            reason = reason_of_points(compared, low=low, high=high, within=within)
            cells.append(_cell(table, (name, row.criterion), said, shown, reason))
    shares = zip(result.total_low / result.ideal, result.total_high / result.ideal, strict=True)
    ranges = [f"{low:.2f}..{high:.2f}" if high - low > 5e-3 else f"{low:.2f}" for low, high in shares]
    printed_shares = tuple(
        "" if one is None else f"{one / (sheet.ideal_sum or result.ideal):.2f}" for one in sheet.sums
    )
    totals = {
        "printed sum": _printed(sheet.sums),
        "printed T/T_max": printed_shares,
        "computed T/T_max": tuple(ranges[place] for place in places),
    }
    return tuple(cells), totals, kesselring(table.matrix, profile=sheet.profile)


def _every_mark(matrix: DecisionMatrix) -> dict[tuple[str, str], str]:
    """Return the mark of every cell, including those after a first ``-``."""
    found = {}
    for criterion in matrix.criteria:
        kept = {key: cell for key, cell in matrix.cells.items() if key[1] == criterion.name}
        for row in eliminate(replace(matrix, criteria=(criterion,), cells=kept)).rows:
            found[row.alternative, criterion.name] = str(row.marks[criterion.name])
    return found


def _compared(table: ComputedTable, key: tuple[str, str], said: Entry, computed: str, other: str) -> Compared:
    planned = table.planned.rows[key[1]].otherwise
    return Compared(
        published=said, computed=computed, figure=table.figures[key], criterion=_criterion(table, key[1]),
        otherwise=other, other_purpose=planned.purpose if planned else "",
        other_figure=table.other_figures.get(key, Figure()),
    )  # fmt: skip


def _cell(table: ComputedTable, key: tuple[str, str], said: Entry, computed: str, reason: Reason) -> ComparedCell:
    shown = said if isinstance(said, str) else f"{said:g}"
    return ComparedCell(
        row=key[1], alternative=key[0], published=shown, computed=computed, figure=table.figures[key], reason=reason
    )


def _is_unclear(table: ComputedTable, row: str, book: TableSet) -> bool:
    """Return whether the row's name does not state which direction is better."""
    return any(repr(row) in finding.what for finding in polarity_unclear(table.sheet, book))


def _criterion(table: ComputedTable, name: str) -> Criterion:
    return next(one for one in table.matrix.criteria if one.name == name)


def _printed(values: tuple[float | None, ...] | tuple[int | None, ...]) -> tuple[str, ...]:
    return tuple("" if value is None else f"{value:g}" for value in values)
