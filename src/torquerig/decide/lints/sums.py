"""Lints of printed sums and products: they must follow from the cells."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.lost_cells import ROUNDING, lost_cell_values
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet
from torquerig.decide.matrix_io.recompute import points_of, recomputed_kesselring, recomputed_pugh, weighted_nets

LINT = "sums that do not follow from the cells"


def sums_do_not_follow(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find printed sums that the cells cannot give for any value of the unknown ones."""
    if table.method is Method.KESSELRING:
        return [*_ideal(table), *_weighted(table), *_spare(table)]
    return _net(table) if table.method is Method.PUGH else []


def products_do_not_follow(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find printed products that are not weight times points."""
    found = []
    for row in table.rows:
        for name, points, product in zip(table.alternatives, row.numbers, row.products or row.numbers, strict=True):
            if not row.products or points is None or product is None or row.weight is None:
                continue
            if abs(points * row.weight - product) > ROUNDING:
                found.append(
                    about(
                        row,
                        lint="products that do not follow",
                        table=table.name,
                        what=f"{name}: {row.weight:g} x {points:g} is {points * row.weight:g}, printed is {product:g}",
                        why="the sum is wrong or uses another score",
                        remedy="correct the product or the score",
                    )
                )
    return found


def _net(table: MatrixTable) -> list[Finding]:
    result, heavy = recomputed_pugh(table), weighted_nets(table)
    found = []
    for place, (name, printed) in enumerate(zip(table.alternatives, table.sums, strict=False)):
        ends = [(float(result.net_low[place + 1]), float(result.net_high[place + 1]))]
        ends += [(float(heavy[0, place]), float(heavy[2, place]))] if table.has_weights else []
        if printed is not None and not any(low - ROUNDING <= printed <= high + ROUNDING for low, high in ends):
            given = [f"{low:.4g}" if low == high else f"{low:.4g}..{high:.4g}" for low, high in ends]
            said = f"{given[0]}, weighted {given[1]}" if table.has_weights else given[0]
            found.append(_finding(table, f"{name}: the printed sum is {printed:g}, the signs give {said}"))
    return found


def _weighted(table: MatrixTable) -> list[Finding]:
    result = recomputed_kesselring(table)
    found = []
    for place, (name, printed) in enumerate(zip(table.alternatives, table.sums, strict=False)):
        if printed is None or _reachable(table, name, printed):
            continue
        low, high = float(result.total_low[place]), float(result.total_high[place])
        given = f"{low:.4g}" if low == high else f"{low:.4g}..{high:.4g}"
        found.append(
            _finding(
                table,
                f"{name}: the printed sum is {printed:g}, the cells give {given}{_one_cell(table, name, printed)}",
            )
        )
    return found


def _ideal(table: MatrixTable) -> list[Finding]:
    ideal = recomputed_kesselring(table).ideal
    if table.ideal_sum is None or abs(table.ideal_sum - ideal) <= ROUNDING:
        return []
    return [_finding(table, f"the ideal's printed sum is {table.ideal_sum:g}, the weights give {ideal:.4g}")]


def _spare(table: MatrixTable) -> list[Finding]:
    found = []
    for spare in table.spare_sums:
        givers = [name for name in table.alternatives if _reachable(table, name, spare)]
        ends = f"; the cells of {', '.join(givers)} would give it" if givers else "; the cells of no column give it"
        found.append(_finding(table, f"the printed sum {spare:g} belongs to no column{ends}"))
    return found


def _reachable(table: MatrixTable, name: str, printed: float) -> bool:
    return bool(lost_cell_values(points_of(table, name), weights=table.weights, total=printed, profile=table.profile))


def _one_cell(table: MatrixTable, name: str, printed: float) -> str:
    """Return the single changes, in half points, that would correct the sum."""
    points = points_of(table, name)
    ways = []
    for place, row in enumerate(table.rows):
        lost = [None if other == place else one for other, one in enumerate(points)]
        options = (
            lost_cell_values(lost, weights=table.weights, total=printed, profile=table.profile)
            if None not in points
            else ()
        )
        ways += [f"{row.criterion!r} were {option[place]:g}" for option in options]
    return f" (correct if {' or '.join(ways)})" if ways else " (no single change by half points corrects it)"


def _finding(table: MatrixTable, what: str) -> Finding:
    return about(
        table,
        lint=LINT,
        table=table.name,
        what=what,
        why="the printed order does not follow from the printed cells",
        remedy="find the lost or moved cells in the source; until then leave them unknown",
    )
