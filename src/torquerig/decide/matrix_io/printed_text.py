"""Printed tables beside what their cells give: published sums and ranks in one column, recomputed ones in the next."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.decide.criterion import Kind
from torquerig.decide.fillings import fillings
from torquerig.decide.kesselring import KesselringResult
from torquerig.decide.matrix_io.recompute import (
    points_of,
    recomputed_chart,
    recomputed_kesselring,
    recomputed_pugh,
    technical_shares,
    undeciding_rows,
)
from torquerig.decide.matrix_io.sheet import Entry, Method, Sheet
from torquerig.decide.matrix_io.text import heading, span, tell_kesselring
from torquerig.decide.ranks import competition_ranks, dense_ranks, shown_rank
from torquerig.plain_table import grid, wrapped


def tell_sheet(sheet: Sheet) -> str:
    """Return one published table as printed, then recomputed."""
    section = f" (section {sheet.section})" if sheet.section else ""
    parts = [heading(f"{sheet.name}{section}: {sheet.title or sheet.method.value}")]
    if sheet.printed:
        parts.append("as it stands in the source:\n" + sheet.printed.rstrip())
    parts.append(_TELL[sheet.method](sheet))
    notes = [sheet.note, *(f"{row.criterion}: {row.note}" for row in sheet.rows if row.note)]
    parts += [wrapped(f"note: {note}") for note in notes if note]
    return "\n\n".join(parts)


def _tell_elimination(sheet: Sheet) -> str:
    set_aside = tuple(row.criterion for row in undeciding_rows(sheet)) if None not in sheet.passed else ()
    strict, loose = recomputed_chart(sheet), recomputed_chart(sheet, without=set_aside)
    printed = [{True: "Yes", False: "No", None: ""}[passed] for passed in sheet.passed]
    head = ["", *(row.criterion for row in sheet.rows), "printed", "strict", "without wishes"]
    body = [
        [name, *(str(entry) for entry in sheet.column(name)), said, str(hard.decision), str(soft.decision)]
        for name, said, hard, soft in zip(sheet.alternatives, printed, strict.rows, loose.rows, strict=True)
    ]
    told = [grid([head, *body]), "strict: every - eliminates; a ? leaves the row open"]
    if set_aside:
        told.append(wrapped(f"without wishes: the columns that never decide are set aside: {', '.join(set_aside)}"))
    return "\n".join(told)


def _tell_pugh(sheet: Sheet) -> str:
    result, corrected = recomputed_pugh(sheet), recomputed_pugh(sheet, correct_datum=True)
    best, worst = result.rank_range
    others = [result.alternatives.index(name) for name in sheet.alternatives]
    nets = result.net_certain[others]
    body = [[row.criterion, "S", *(str(entry) for entry in row.entries)] for row in sheet.rows]
    body += [
        ["SUM as printed", "", *_printed(sheet.sums, len(others))],
        ["SUM recomputed (? left out)", "0", *(str(net) for net in nets.tolist())],
        ["net with ? either way", "0", *(span(result.net_low[one], result.net_high[one]) for one in others)],
        ["Rank as printed", "", *_printed(sheet.ranks, len(others))],
        ["Rank recomputed (1 2 2 4)", "", *(str(rank) for rank in competition_ranks(nets).tolist())],
        ["Rank recomputed, dense", "", *(str(rank) for rank in dense_ranks(nets).tolist())],
        ["Rank with the datum", *(str(result.ranks[place]) for place in (0, *others))],
        ["Rank with ? either way", *(shown_rank(int(best[place]), int(worst[place])) for place in (0, *others))],
    ]
    if any(row.datum_has for row in sheet.rows):
        body.append(["SUM, S where the datum has it", "0", *(str(corrected.net_certain[one]) for one in others)])
    return grid([["", sheet.datum, *sheet.alternatives], *body])


def _tell_kesselring(sheet: Sheet) -> str:
    result = recomputed_kesselring(sheet)
    ideal = "" if sheet.ideal_sum is None else f"{sheet.ideal_sum:g}"
    sums = [
        ["", "ideal", *sheet.alternatives, *("(no column)" for _ in sheet.spare_sums)],
        ["Sum as printed", ideal, *_printed(sheet.sums, len(sheet.alternatives)), *_printed(sheet.spare_sums, 0)],
        ["Sum recomputed", f"{result.ideal:.4g}", *_totals(result), *("" for _ in sheet.spare_sums)],
    ]
    return "\n".join([tell_kesselring(result), "", grid(sums), *_without_price(sheet), *_lost_cells(sheet)])


def _without_price(sheet: Sheet) -> list[str]:
    economic = [row.criterion for row in sheet.rows if row.kind is Kind.ECONOMIC]
    if not economic:
        return []
    shares = zip(sheet.alternatives, technical_shares(sheet), strict=True)
    known = [f"{name} {share:.3f}" for name, share in shares if None not in points_of(sheet, name)]
    return [wrapped(f"T/T_max without {', '.join(economic)}: {', '.join(known)}")]


def _lost_cells(sheet: Sheet) -> list[str]:
    told = []
    for name, printed in zip(sheet.alternatives, sheet.sums, strict=False):
        points = points_of(sheet, name)
        if printed is None or None not in points:
            continue
        ways = fillings(points, weights=sheet.weights, total=printed, profile=sheet.profile)
        share = printed / (sheet.profile.p_max * sum(sheet.weights))
        told.append(
            wrapped(
                f"{name}: the printed sum {printed:g} (T/T_max {share:.3f}) leaves {len(ways)} fillings of its unknown "
                f"cells in half points on the scale {sheet.profile.p_min:g}-{sheet.profile.p_max:g}"
            )
        )
    return told


def _totals(result: KesselringResult) -> list[str]:
    return [span(low, high) for low, high in zip(result.total_low, result.total_high, strict=True)]


def _printed(values: Sequence[Entry | None], count: int) -> list[str]:
    return ["" if value is None else f"{value:g}" for value in values if not isinstance(value, str)] or [""] * count


_TELL = {
    Method.ELIMINATION: _tell_elimination,
    Method.PUGH: _tell_pugh,
    Method.KESSELRING: _tell_kesselring,
}
