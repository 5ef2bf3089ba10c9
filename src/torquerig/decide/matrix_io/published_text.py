"""Published tables as text: printed sums and ranks together with those recalculated from the cells."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.decide.criterion import Kind
from torquerig.decide.kesselring import KesselringResult
from torquerig.decide.lost_cells import lost_cell_values
from torquerig.decide.matrix_io.matrix_table import Entry, MatrixTable, Method
from torquerig.decide.matrix_io.recompute import (
    points_of,
    recomputed_chart,
    recomputed_kesselring,
    recomputed_pugh,
    technical_shares,
    undeciding_rows,
    weighted_nets,
)
from torquerig.decide.matrix_io.result_text import heading, kesselring_text, span
from torquerig.decide.ranks import competition_ranks, dense_ranks, shown_rank
from torquerig.plain_table import grid, wrapped


def published_table_text(table: MatrixTable) -> str:
    """Return one published table as printed, then recalculated."""
    section = f" (section {table.section})" if table.section else ""
    parts = [heading(f"{table.name}{section}: {table.title or table.method.value}")]
    if table.printed:
        parts.append("as printed in the source:\n" + table.printed.rstrip())
    parts.append(_TEXT[table.method](table))
    notes = [table.note, *(f"{row.criterion}: {row.note}" for row in table.rows if row.note)]
    parts += [wrapped(f"note: {note}") for note in notes if note]
    return "\n\n".join(parts)


def _text_of_elimination(table: MatrixTable) -> str:
    unused = tuple(row.criterion for row in undeciding_rows(table)) if None not in table.passed else ()
    strict, loose = recomputed_chart(table), recomputed_chart(table, without=unused)
    printed = [{True: "Yes", False: "No", None: ""}[passed] for passed in table.passed]
    head = ["", *(row.criterion for row in table.rows), "printed", "strict", "without wishes"]
    body = [
        [name, *(str(entry) for entry in table.column(name)), decision, str(hard.decision), str(soft.decision)]
        for name, decision, hard, soft in zip(table.alternatives, printed, strict.rows, loose.rows, strict=True)
    ]
    lines = [grid([head, *body]), "strict: every - eliminates; a ? leaves the row open"]
    if unused:
        lines.append(wrapped(f"without wishes: left out are the columns that never decide: {', '.join(unused)}"))
    return "\n".join(lines)


def _text_of_pugh(table: MatrixTable) -> str:
    result, corrected = recomputed_pugh(table), recomputed_pugh(table, correct_baseline=True)
    best, worst = result.rank_range
    others = [result.alternatives.index(name) for name in table.alternatives]
    nets = result.net_certain[others]
    body = [[row.criterion, "S", *(str(entry) for entry in row.entries)] for row in table.rows]
    body += [
        ["SUM as printed", "", *_printed(table.sums, len(others))],
        ["SUM recalculated (? left out)", "0", *(str(net) for net in nets.tolist())],
        ["net with ? either way", "0", *(span(result.net_low[one], result.net_high[one]) for one in others)],
        ["Rank as printed", "", *_printed(table.ranks, len(others))],
        ["Rank recalculated (1 2 2 4)", "", *(str(rank) for rank in competition_ranks(nets).tolist())],
        ["Rank recalculated, dense", "", *(str(rank) for rank in dense_ranks(nets).tolist())],
        ["Rank with the baseline", *(str(result.ranks[place]) for place in (0, *others))],
        ["Rank with ? either way", *(shown_rank(int(best[place]), int(worst[place])) for place in (0, *others))],
    ]
    body = [row for row in body if not row[0].endswith("as printed") or any(row[1:])]
    if table.has_weights:
        low, known, high = weighted_nets(table)
        ranks = competition_ranks(known)
        body += [
            ["weighted SUM (? left out)", "0", *(f"{one:.4g}" for one in known)],
            ["weighted SUM, ? either way", "0", *(span(*ends) for ends in zip(low, high, strict=True))],
            ["Rank by weighted SUM (1 2 2 4)", "", *(str(rank) for rank in ranks.tolist())],
        ]
    if any(row.baseline_has for row in table.rows):
        body.append(["SUM, S where the baseline has it", "0", *(str(corrected.net_certain[one]) for one in others)])
    if not table.has_weights:
        return grid([["", table.baseline, *table.alternatives], *body])
    weights = [f"{row.weight or 0:.4g}" for row in table.rows] + [""] * (len(body) - len(table.rows))
    body = [[name, weight, *cells] for (name, *cells), weight in zip(body, weights, strict=True)]
    said = "weighted SUM: weight times sign, ++ as 2; SUM: the signs alone"
    return "\n".join([grid([["", "weight", table.baseline, *table.alternatives], *body]), said])


def _text_of_kesselring(table: MatrixTable) -> str:
    result = recomputed_kesselring(table)
    ideal = "" if table.ideal_sum is None else f"{table.ideal_sum:g}"
    if not (table.sums or table.spare_sums or table.ideal_sum is not None):
        return kesselring_text(result)
    sums = [
        ["", "ideal", *table.alternatives, *("(no column)" for _ in table.spare_sums)],
        ["Sum as printed", ideal, *_printed(table.sums, len(table.alternatives)), *_printed(table.spare_sums, 0)],
        ["Sum recalculated", f"{result.ideal:.4g}", *_totals(result), *("" for _ in table.spare_sums)],
    ]
    return "\n".join([kesselring_text(result), "", grid(sums), *_without_price(table), *_lost_cells(table)])


def _without_price(table: MatrixTable) -> list[str]:
    economic = [row.criterion for row in table.rows if row.kind is Kind.ECONOMIC]
    if not economic:
        return []
    shares = zip(table.alternatives, technical_shares(table), strict=True)
    known = [f"{name} {share:.3f}" for name, share in shares if None not in points_of(table, name)]
    return [wrapped(f"T/T_max without {', '.join(economic)}: {', '.join(known)}")]


def _lost_cells(table: MatrixTable) -> list[str]:
    lines = []
    for name, printed in zip(table.alternatives, table.sums, strict=False):
        points = points_of(table, name)
        if printed is None or None not in points:
            continue
        ways = lost_cell_values(points, weights=table.weights, total=printed, profile=table.profile)
        share = printed / (table.profile.p_max * sum(table.weights))
        lines.append(
            wrapped(
                f"{name}: the printed sum {printed:g} (T/T_max {share:.3f}) allows {len(ways)} sets of values of its "
                f"unknown cells in half points on the scale {table.profile.p_min:g}-{table.profile.p_max:g}"
            )
        )
    return lines


def _totals(result: KesselringResult) -> list[str]:
    return [span(low, high) for low, high in zip(result.total_low, result.total_high, strict=True)]


def _printed(values: Sequence[Entry | None], count: int) -> list[str]:
    return ["" if value is None else f"{value:g}" for value in values if not isinstance(value, str)] or [""] * count


_TEXT = {
    Method.ELIMINATION: _text_of_elimination,
    Method.PUGH: _text_of_pugh,
    Method.KESSELRING: _text_of_kesselring,
}
