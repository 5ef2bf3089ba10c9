"""The three matrices of a study as tables of the page."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from torquerig.decide.pugh import Sign
from torquerig.decide.ranks import shown_rank
from torquerig.reporting.figures.shades import GOOD_IS_HIGH, mark_style, shade
from torquerig.reporting.layout import Cell, Table, number, span, words
from torquerig.reporting.study.tables import rank_texts
from torquerig.reporting.study.trace_tables import trace_anchor

if TYPE_CHECKING:
    from torquerig.decide.eliminate import SelectionChart
    from torquerig.decide.matrix import Criterion, DecisionMatrix
    from torquerig.study.scoring import Decided


def rule_text(criterion: Criterion) -> str:
    """Return the requirement of a criterion as a formula."""
    return (
        criterion.name if criterion.requirement is None else criterion.requirement.rule(criterion.name, criterion.unit)
    )


def elimination_table(chart: SelectionChart, requirements: DecisionMatrix) -> Table:
    """Return the chart, each sign with its remark as tooltip, and all remarks as text."""
    rows = []
    for row in chart.rows:
        remarks = {remark.criterion: remark.sentence() for remark in row.remarks}
        cells = []
        for name in chart.criteria:
            mark = str(row.marks.get(name, ""))
            shown = requirements.cell(row.alternative, name).shown() if mark else "not tested"
            way = f"#{trace_anchor(row.alternative)}"
            cells.append(Cell(text=mark, style=mark_style(mark), word="mark", title=remarks.get(name, shown), link=way))
        said = "; ".join(remarks.values())
        rows.append((*words(row.alternative), *cells, Cell(text=str(row.decision)), Cell(text=said, word="remark")))
    head = tuple(rule_text(criterion) for criterion in requirements.criteria if criterion.name in chart.criteria)
    return Table(
        caption="Elimination: + meets the requirement, - fails it, ? the value is missing, ! check the requirement; "
        "criteria after the first - are not tested",
        head=("drive", *head, "decision", "remarks"), rows=tuple(rows),
    )  # fmt: skip


def pugh_table(decided: Decided, names: Sequence[str]) -> Table:
    """Return the signs of the named combinations against the baseline, their counts, and the net score."""
    result = decided.pugh
    best, worst = (ends.tolist() for ends in result.rank_range)
    rows = []
    for name in names:
        place, counts = result.alternatives.index(name), result.counts(name)
        way = _way(decided, name)
        marks = (
            Cell(text=str(sign), style=mark_style(str(sign)), word="mark", link=way) for sign in result.signs(name)
        )
        net = span(float(result.net_low[place]), float(result.net_high[place]))
        rows.append((*words(name), *marks, *(number(str(counts[sign])) for sign in Sign), number(net),
                     number(shown_rank(best[place], worst[place]))))  # fmt: skip
    return Table(
        caption=f"Pugh: each drive with its best filter against the baseline {result.baseline}; with the number "
        "of each sign",
        head=("combination", *result.criteria, *(str(sign) for sign in Sign), "net (option)", "rank by net"),
        rows=tuple(rows), emphasised=frozenset(place for place, name in enumerate(names) if name == result.baseline),
        note="Pugh's result is the counts. The net of pluses and minuses weights all criteria equally and is optional. "
        "A ? never counts as S. The rank is among all combinations, see matrices.xlsx.",
    )  # fmt: skip


def kesselring_table(decided: Decided, names: Sequence[str]) -> Table:
    """Return weights, the ideal, and the weighted points of the named combinations."""
    result, ranks = decided.overall, rank_texts(decided)
    top = result.profile.p_max
    rows = [
        (*words("weight as given"), *(number(f"{one:.4g}") for one in result.weights), number(f"{result.weight_sum:g}"),
         *words("", "")),
        (*words("weight normalised"), *(number(f"{one:.3f}") for one in result.normalised), number("1"),
         *words("", "")),
        (*words("ideal"), *(number(f"{top:g}") for _ in result.criteria), number(f"{result.ideal:.4g}"),
         number("1"), *words("")),
    ]  # fmt: skip
    for name in names:
        row = result.alternatives.index(name)
        way = _way(decided, name)
        points = [
            Cell(text=span(low, high, 2), style=shade(middle, result.profile.p_min, top, scale=GOOD_IS_HIGH),
                 word="number", link=way)
            for low, high, middle in zip(result.low[row], result.high[row], result.middle[row], strict=True)
        ]  # fmt: skip
        total = f"{result.total[row]:.3g} ({span(result.total_low[row], result.total_high[row])})"
        rank = ranks[name]
        rows.append((*words(name), *points, number(total), number(f"{result.share[row]:.3f}"), number(rank)))
    return Table(
        caption=f"Kesselring, scale {result.profile.p_min:g} to {top:g}: points (a range where values are "
        "uncertain), T with its range, T/T_max, and the rank among all combinations with its range",
        head=("combination", *result.criteria, "T", "T/T_max", "rank"), rows=tuple(rows),
        emphasised=frozenset({2}), note=result.warning,
    )  # fmt: skip


def _way(decided: Decided, name: str) -> str:
    """Return the link to the calculation of a combination's cells; empty where the page shows another filter."""
    drive = decided.alternatives[name].drive.candidate.name
    best = next(one for one in decided.ranked() if decided.alternatives[one].drive.candidate.name == drive)
    return f"#{trace_anchor(drive)}" if name == best else ""
