"""Whether the printed sums and products follow from the cells."""

from __future__ import annotations

from torquerig.decide.fillings import ROUNDING, fillings
from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.recompute import points_of, recomputed_kesselring, recomputed_pugh
from torquerig.decide.matrix_io.sheet import Book, Method, Sheet

LINT = "sums that do not follow from the cells"


def sums_do_not_follow(sheet: Sheet, book: Book) -> list[Finding]:
    """Find printed sums that the cells cannot give, whatever stands in the unknown ones."""
    if sheet.method is Method.KESSELRING:
        return [*_ideal(sheet), *_weighted(sheet), *_spare(sheet)]
    return _net(sheet) if sheet.method is Method.PUGH else []


def products_do_not_follow(sheet: Sheet, book: Book) -> list[Finding]:
    """Find printed products that are not weight times points."""
    found = []
    for row in sheet.rows:
        for name, points, product in zip(sheet.alternatives, row.numbers, row.products or row.numbers, strict=True):
            if not row.products or points is None or product is None or row.weight is None:
                continue
            if abs(points * row.weight - product) > ROUNDING:
                found.append(
                    about(
                        row,
                        lint="products that do not follow",
                        table=sheet.name,
                        what=f"{name}: {row.weight:g} x {points:g} is {points * row.weight:g}, printed is {product:g}",
                        why="the sum below it is wrong or rests on another score",
                        remedy="correct the product or the score",
                    )
                )
    return found


def _net(sheet: Sheet) -> list[Finding]:
    result = recomputed_pugh(sheet)
    found = []
    for place, (name, printed) in enumerate(zip(sheet.alternatives, sheet.sums, strict=False), start=1):
        low, high = int(result.net_low[place]), int(result.net_high[place])
        if printed is not None and not low <= printed <= high:
            given = f"{low}" if low == high else f"{low}..{high}"
            found.append(_finding(sheet, f"{name}: the printed sum is {printed:g}, the signs give {given}"))
    return found


def _weighted(sheet: Sheet) -> list[Finding]:
    result = recomputed_kesselring(sheet)
    found = []
    for place, (name, printed) in enumerate(zip(sheet.alternatives, sheet.sums, strict=False)):
        if printed is None or _reachable(sheet, name, printed):
            continue
        low, high = float(result.total_low[place]), float(result.total_high[place])
        given = f"{low:.4g}" if low == high else f"{low:.4g}..{high:.4g}"
        found.append(
            _finding(
                sheet,
                f"{name}: the printed sum is {printed:g}, the cells give {given}{_one_cell(sheet, name, printed)}",
            )
        )
    return found


def _ideal(sheet: Sheet) -> list[Finding]:
    ideal = recomputed_kesselring(sheet).ideal
    if sheet.ideal_sum is None or abs(sheet.ideal_sum - ideal) <= ROUNDING:
        return []
    return [_finding(sheet, f"the ideal's printed sum is {sheet.ideal_sum:g}, the weights give {ideal:.4g}")]


def _spare(sheet: Sheet) -> list[Finding]:
    found = []
    for spare in sheet.spare_sums:
        givers = [name for name in sheet.alternatives if _reachable(sheet, name, spare)]
        ends = f"; the cells of {', '.join(givers)} would give it" if givers else "; no column's cells give it"
        found.append(_finding(sheet, f"the printed sum {spare:g} belongs to no column{ends}"))
    return found


def _reachable(sheet: Sheet, name: str, printed: float) -> bool:
    return bool(fillings(points_of(sheet, name), weights=sheet.weights, total=printed, profile=sheet.profile))


def _one_cell(sheet: Sheet, name: str, printed: float) -> str:
    """Return the single changes, in half points, that would make the sum right."""
    points = points_of(sheet, name)
    ways = []
    for place, row in enumerate(sheet.rows):
        lost = [None if other == place else one for other, one in enumerate(points)]
        options = (
            fillings(lost, weights=sheet.weights, total=printed, profile=sheet.profile) if None not in points else ()
        )
        ways += [f"{row.criterion!r} were {option[place]:g}" for option in options]
    return f" (right if {' or '.join(ways)})" if ways else " (no single half-point change makes it right)"


def _finding(sheet: Sheet, what: str) -> Finding:
    return about(
        sheet,
        lint=LINT,
        table=sheet.name,
        what=what,
        why="a reader cannot get the printed order from the printed cells",
        remedy="find the lost or moved cells in the source; until then keep them unknown",
    )
