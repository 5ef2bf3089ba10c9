"""Selection chart, Pugh, Kesselring and findings as plain text."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.decide.criterion import Criterion
from torquerig.decide.eliminate import SelectionChart
from torquerig.decide.kesselring import KesselringResult
from torquerig.decide.lints.finding import Finding
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.pugh import BaselineSweep, PughResult, Sign
from torquerig.decide.ranks import shown_rank
from torquerig.plain_table import grid, wrapped


def heading(text: str) -> str:
    """Return a heading with a line under it."""
    return f"{text}\n{'=' * len(text)}"


def span(low: float, high: float) -> str:
    """Return ``2.85`` or ``1.15..3.35``."""
    return f"{low:.4g}" if abs(high - low) < 1e-9 else f"{low:.4g}..{high:.4g}"


def known_values_text(matrix: DecisionMatrix) -> str:
    """Return the known values, one line per alternative, with units in the head."""
    head = ["", *(_with_unit(criterion) for criterion in matrix.criteria)]
    body = [
        [name, *(matrix.cell(name, criterion.name).shown() for criterion in matrix.criteria)]
        for name in matrix.alternatives
    ]
    return grid([head, *body])


def chart_text(chart: SelectionChart, *, remarks: bool = True) -> str:
    """Return the selection chart with its decisions, and under it a remark for every cell that is not ``+``."""
    head = ["", *chart.criteria, "decision"]
    body = [
        [row.alternative, *(str(row.marks.get(name, "")) for name in chart.criteria), str(row.decision)]
        for row in chart.rows
    ]
    lines = [
        wrapped(f"{row.alternative}: {remark.sentence()}", rest="    ")
        for row in chart.rows
        for remark in (row.remarks if remarks else ())
    ]
    return "\n".join([grid([head, *body]), *lines])


def pugh_text(result: PughResult) -> str:
    """Return the signs with their counts, and the net with its interval as an option."""
    best, worst = result.rank_range
    columns = {name: result.signs(name) for name in result.alternatives}
    head = ["", *(f"{name} (baseline)" if name == result.baseline else name for name in result.alternatives)]
    body = [
        [criterion, *(str(columns[name][place]) for name in columns)] for place, criterion in enumerate(result.criteria)
    ]
    body += [[f"count {sign}", *(str(result.counts(name)[sign]) for name in columns)] for sign in Sign]
    body.append(["net (optional)", *(span(*ends) for ends in zip(result.net_low, result.net_high, strict=True))])
    body.append(["rank by net", *(shown_rank(*ends) for ends in zip(best.tolist(), worst.tolist(), strict=True))])
    return grid([head, *body])


def sweep_text(sweep: BaselineSweep) -> str:
    """Return on how many criteria the row certainly beats the column, and the winner under each baseline."""
    body = [
        [name, *(("." if name == other else str(count)) for other, count in zip(sweep.alternatives, row, strict=True))]
        for name, row in zip(sweep.alternatives, sweep.wins.tolist(), strict=True)
    ]
    lines = [f"baseline {baseline}: best net {', '.join(names)}" for baseline, names in sweep.winners.items()]
    winner = sweep.condorcet_winner
    lines.append(
        f"certainly beats every other one: {winner}" if winner else "no alternative certainly beats every other one"
    )
    return "\n".join([grid([["row beats column on", *sweep.alternatives], *body]), *lines])


def kesselring_text(result: KesselringResult) -> str:
    """Return points with raw and normalised weights, the ideal column, T, T/T_max, ranks and weak spots."""
    best, worst = result.rank_range
    head = ["", "weight", "normalised", "ideal", *result.alternatives]
    body = [
        [
            criterion,
            f"{result.weights[column]:.4g}",
            f"{result.normalised[column]:.3f}",
            f"{result.profile.p_max:g}",
            *(
                span(*ends) + ("*" if (name, criterion) in result.by_hand else "")
                for name, *ends in zip(result.alternatives, result.low[:, column], result.high[:, column], strict=True)
            ),
        ]
        for column, criterion in enumerate(result.criteria)
    ]
    totals = list(zip(result.total_low.tolist(), result.total_high.tolist(), strict=True))
    ideal = result.ideal
    body.append(["T", f"{result.weight_sum:.4g}", "1", f"{ideal:.4g}", *(span(*ends) for ends in totals)])
    body.append(
        ["T/T_max", "", "", "1", *(f"{span(round(low / ideal, 3), round(high / ideal, 3))}" for low, high in totals)]
    )
    body.append(["rank", "", "", "", *(shown_rank(*ends) for ends in zip(best.tolist(), worst.tolist(), strict=True))])
    if not result.profile.stated:
        return _without_ideal(result, head, body)
    lines = [f"warning: {result.warning}"] if result.warning else []
    lines += [f"* set by hand: {name}, {criterion!r}: {why}" for (name, criterion), why in result.by_hand.items()]
    lines += [
        f"weak spot: {spot.alternative} gets at most {spot.points:g} for {spot.criterion!r}, "
        f"hidden by T/T_max = {spot.share:.2f}"
        for spot in result.weak_spots
    ]
    return "\n".join([grid([head, *body]), *lines])


def _without_ideal(result: KesselringResult, head: list[str], body: list[list[str]]) -> str:
    """Return the table where the scale is not stated: sums and ranks, nothing that depends on the highest points."""
    kept = [[*row[:3], *row[4:]] for row in (head, *body) if row[0] != "T/T_max" or row is head]
    said = "the sheet states no points scale: T/T_max is not known; write for example 'scale 0 to 4' in a cell"
    return "\n".join([grid(kept), *([f"warning: {result.warning}"] if result.warning else []), said])


def findings_text(findings: Sequence[Finding]) -> str:
    """Return the audit as a numbered list: what, why it matters, remedy, place."""
    if not findings:
        return "nothing found"
    lines = []
    for number, finding in enumerate(findings, start=1):
        lines.append(wrapped(f"{number}. {finding.table}: {finding.lint}: {finding.what}.", rest="   "))
        lines.append(wrapped(f"why: {finding.why}.", first="   ", rest="   "))
        lines.append(wrapped(f"remedy: {finding.remedy}.", first="   ", rest="   "))
        if finding.place:
            lines.append(f"   at {finding.place}")
    return "\n".join(lines)


def _with_unit(criterion: Criterion) -> str:
    return criterion.name if criterion.unit in ("1", "yes/no") else f"{criterion.name} [{criterion.unit}]"
