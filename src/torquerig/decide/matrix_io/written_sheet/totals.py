"""The results written below a matrix, compared with those computed from its cells."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method
from torquerig.decide.matrix_io.recompute import recomputed_kesselring, recomputed_pugh, weighted_nets
from torquerig.decide.matrix_io.written_sheet.lines import Lines
from torquerig.decide.matrix_io.written_sheet.words import Total
from torquerig.decide.matrix_io.written_values import LEVELS, may_be_thousands, number_of, weight_of
from torquerig.decide.ranks import TIE, competition_ranks, dense_ranks
from torquerig.errors import InputError

EXACT = 1e-6  # [1] relative rounding of a spreadsheet program's sums

Values = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """One way to compute a result: its name, and the lowest and highest value per alternative."""

    name: str
    low: Values
    high: Values


def totals_compared(lines: Lines, table: MatrixTable) -> list[str]:
    """Return a sentence for each result of the sheet: that it agrees and how it is computed, or the difference."""
    grid, ways = lines.grid, _candidates(table)
    said = []
    for row, kind in lines.totals.items():
        cells = {name: grid.cells.get((row, _sum_column(lines, row, c))) for name, c in _columns(lines, table).items()}
        where = f"{grid.text(row, lines.block.labels)!r} in {grid.name(row, lines.block.labels)}"
        printed = {name: cell for name, cell in cells.items() if _number(cell) is not None}
        if not printed:
            continue
        said.append(_rank_sentence(where, printed, table, ways) if kind is Total.RANK else
                    _sentence(where, printed, table, ways.get(kind, ())))  # fmt: skip
    return [*said, *_datum_differences(lines, table)]


def _datum_differences(lines: Lines, table: MatrixTable) -> list[str]:
    """Return the written results of the datum that are not 0; its count of S is the number of criteria."""
    said = []
    for row, kind in lines.totals.items():
        cell = None if lines.datum is None else lines.grid.cells.get((row, lines.datum))
        found, wanted = _number(cell), len(table.rows) if kind is Total.SAME else 0
        if found is not None and kind is not Total.RANK and lines.datum is not None and found != wanted:
            where = lines.grid.name(row, lines.datum)
            said.append(f"difference: the datum in {where} has {found:g}; compared with itself it has {wanted}")
    return said


def refuse_unnamed_result(lines: Lines, table: MatrixTable) -> None:
    """Raise InputError where the last criterion holds a result of those above it, under a name that is not known.

    With weights, its weight must be their sum too: a result has no weight of its own.
    """
    *above, last = table.rows
    printed = dict(zip(table.alternatives, last.numbers, strict=True))
    cells = [lines.grid.cells.get((next(reversed(lines.criteria)), column)) for column in lines.rated]
    is_numeric = all(number_of(cell) is not None and "+" not in str(cell) for cell in cells)
    if len(above) < 2 or not is_numeric or None in printed.values() or not any(printed.values()):
        return
    weighed = [row.weight or 0.0 for row in above]
    if lines.weights is not None and abs((last.weight or 0.0) - sum(weighed)) > EXACT:
        return
    ways = _candidates(replace(table, rows=tuple(above)))
    candidates = [way for kind in (Total.SUM, Total.MEAN) for way in ways[kind]]
    same = [way for way in candidates if not _differences(printed, table, way)]
    if same:
        where = lines.grid.place(next(reversed(lines.criteria)), lines.block.labels)
        raise InputError(
            f"{where}: {last.criterion!r} may be a criterion, or {same[0].name} of those above, which it equals; "
            f"rename it to 'sum', 'mean' or 'rank' if it is a result; move it up if it is a criterion"
        )


def refuse_weighted_total(lines: Lines, table: MatrixTable) -> None:
    """Raise InputError where a line named as a result has a weight of its own and does not follow from the cells."""
    for row, kind in lines.totals.items():
        if lines.weights is None or weight_of(lines.grid.cells.get((row, lines.weights))) is None:
            continue
        said = totals_compared(replace(lines, totals={row: kind}, datum=None), table)
        if (kind is Total.RANK or weight_total(lines, table.weights, row)) and any("difference" in one for one in said):
            where, name = lines.grid.place(row, lines.block.labels), lines.grid.text(row, lines.block.labels)
            raise InputError(
                f"{where}: {name!r} is the name of a result, but has a weight and other values; rename it if it is a "
                "criterion, or clear its weight"
            )


def weight_total(lines: Lines, weights: Sequence[float], row: int) -> str:
    """Return the difference between the sum of the weights that the sheet states and theirs; empty if none."""
    found = None if lines.weights is None else weight_of(lines.grid.cells.get((row, lines.weights)))
    total = sum(weights)
    if found is None or lines.totals[row] is Total.RANK or lines.weights is None:
        return ""
    if any(abs(found[0] * scale - total) <= EXACT * abs(total) + 1e-9 for scale in (1, 0.01)):
        return ""
    where = lines.grid.name(row, lines.weights)
    return f"difference: the sum of the weights in {where} is {found[0]:g}, the weights sum to {total:g}"


def _columns(lines: Lines, table: MatrixTable) -> dict[str, int]:
    return {lines.names[column]: column for column in lines.rated if lines.names[column] in table.alternatives}


def _sum_column(lines: Lines, row: int, column: int) -> int:
    """Return where the result of an alternative is: under its products, if there are such, else under its points."""
    product = lines.products.get(column)
    return product if product is not None and (row, product) in lines.grid.cells else column


def _candidates(table: MatrixTable) -> dict[Total, tuple[Candidate, ...]]:
    if table.method is Method.PUGH:
        result = recomputed_pugh(table)
        known = [result.net_low[1:].astype(float), result.net_high[1:].astype(float)]
        plain = Candidate(name="the unweighted sum of the marks", low=known[0], high=known[1])
        ends = weighted_nets(table)[[0, 2]] if table.has_weights else None
    else:
        rated = recomputed_kesselring(table)
        numbers = np.array([[row.numbers[place] for row in table.rows] for place in range(len(table.alternatives))],
                           dtype=float)  # fmt: skip
        low = np.where(np.isnan(numbers), table.profile.p_min, numbers).sum(axis=1)
        high = np.where(np.isnan(numbers), table.profile.p_max, numbers).sum(axis=1)
        plain = Candidate(name="the sum of the points without weights", low=low, high=high)
        ends = np.stack([rated.total_low, rated.total_high])
    weighted = () if ends is None else _weighted(ends, sum(table.weights))
    ways: dict[Total, tuple[Candidate, ...]] = {
        Total.PLAIN: (plain,), Total.MEAN: (_mean(plain, len(table.rows)), *weighted[1:2]), Total.WEIGHTED: weighted,
        Total.SUM: (plain, *weighted) if table.method is Method.PUGH else (*weighted, plain),
    }  # fmt: skip
    if table.method is Method.PUGH:
        return ways | {kind: _counts(table, kind) for kind in (Total.BETTER, Total.WORSE, Total.SAME)}
    if table.profile.stated:
        share = np.stack([rated.total_low, rated.total_high]) / rated.ideal
        ways[Total.SHARE] = tuple(
            Candidate(name=name, low=share[0] * scale, high=share[1] * scale)
            for name, scale in (("T/T_max", 1.0), ("T/T_max in per cent", 100.0))
        )
    return ways


def _mean(total: Candidate, count: int) -> Candidate:
    return Candidate(name="the mean without weights", low=total.low / count, high=total.high / count)


def _weighted(ends: Values, whole: float) -> tuple[Candidate, ...]:
    scales = {"the weighted sum": 1.0, "the weighted mean": 1 / whole, "the weighted sum over 100": 0.01,
              "100 times the weighted sum": 100.0}  # fmt: skip
    return tuple(Candidate(name=name, low=ends[0] * scale, high=ends[1] * scale) for name, scale in scales.items())


def _counts(table: MatrixTable, kind: Total) -> tuple[Candidate, ...]:
    sign = {Total.BETTER: 1, Total.WORSE: -1, Total.SAME: 0}[kind]
    once, double, unknown = (np.zeros(len(table.alternatives)) for _ in range(3))
    for place, name in enumerate(table.alternatives):
        levels = [LEVELS.get("S" if one == "0" else str(one)) for one in table.column(name)]
        hits = [level for level in levels if level is not None and (level > 0) - (level < 0) == sign]
        once[place], double[place] = len(hits), sum(max(1, abs(level)) for level in hits)
        unknown[place] = levels.count(None)
    names = (f"the {kind.value}", once), (f"the {kind.value}, double marks as two", double)
    return tuple(
        Candidate(name=name, low=values * way, high=(values + unknown) * way)
        for name, values in names
        for way in ((1, -1) if sign < 0 else (1,))
    )


def _sentence(where: str, printed: Mapping[str, object], table: MatrixTable, candidates: Sequence[Candidate]) -> str:
    if not candidates:
        return f"{where}: not compared, because the sheet has no weights or no scale from which it follows"
    best = min(candidates, key=lambda one: len(_differences(printed, table, one)))
    wrong = _differences(printed, table, best)
    if not wrong:
        return f"{where} is {best.name}, and agrees with the cells"
    close = [best] if len(wrong) < len(printed) else candidates[:2]
    computed = "; ".join(
        f"{name}: the sheet has {_number(printed[name]):g}, the cells give "
        + " or ".join(f"{_range(one, table.alternatives.index(name))} ({one.name})" for one in close)
        for name in wrong
    )
    return f"difference: {where}: {computed}"


def _differences(printed: Mapping[str, object], table: MatrixTable, way: Candidate) -> list[str]:
    wrong = []
    for name, cell in printed.items():
        place = table.alternatives.index(name)
        low, high = way.low[place], way.high[place]
        tolerance = _rounding(cell) + EXACT * max(abs(low), abs(high)) + 1e-9
        readings = [_number(cell), *([float("".join(c for c in str(cell) if c in "+-0123456789"))]
                                     if may_be_thousands(cell) else [])]  # fmt: skip
        if not any(low - tolerance <= one <= high + tolerance for one in readings if one is not None):
            wrong.append(name)
    return wrong


def _rank_sentence(
    where: str, printed: Mapping[str, object], table: MatrixTable, ways: Mapping[Total, Sequence[Candidate]]
) -> str:
    places = [table.alternatives.index(name) for name in printed]
    ranks = [_number(cell) for cell in printed.values()]
    for way in ways[Total.SUM]:
        if (way.low != way.high).any():
            return f"{where}: not compared, because unknown values leave the ranks open"
        others = way.low[places]
        shifted = competition_ranks(np.append(others, 0.0))[:-1].tolist()  # the datum takes a rank, too
        for given in (competition_ranks(others).tolist(), dense_ranks(others).tolist(), shifted):
            if given == ranks:
                return f"{where} is the rank by {way.name}, and agrees with the cells"
        ordered = [total for _, total in sorted(zip([one or 0.0 for one in ranks], others.tolist(), strict=True))]
        if sorted(one or 0.0 for one in ranks) == list(range(1, len(ranks) + 1)) and all(
            ordered[at] >= ordered[at + 1] - TIE for at in range(len(ordered) - 1)
        ):
            return f"{where} is the rank by {way.name} with ties in any order, and agrees with the cells"
    way = ways[Total.SUM][0]
    own = competition_ranks(way.low[places]).tolist()
    pairs = zip(printed, own, strict=True)
    computed = ", ".join(f"{name} {_number(printed[name]):g} (computed {rank})" for name, rank in pairs)
    return f"difference: {where}: the ranks do not follow from the cells: {computed}, by {way.name}"


def _range(way: Candidate, place: int) -> str:
    low, high = way.low[place], way.high[place]
    return f"{low:.4g}" if high - low < 1e-9 else f"{low:.4g}..{high:.4g}"


def _number(cell: object) -> float | None:
    """Return a result as a number; per cent stay as written with their factor."""
    found = weight_of(cell)
    return number_of(cell) if found is None else found[0]


def _rounding(cell: object) -> float:
    """Return half a unit of the last decimal that a result was written with; 0 for whole numbers."""
    text = (cell if isinstance(cell, str) else f"{cell!r}").strip()
    scale = 0.01 if text.endswith("%") else 1.0
    _, _, decimals = text.rstrip("% ").replace(",", ".").partition(".")
    if not decimals or not decimals.isdigit() or not decimals.strip("0"):
        return 0.5 * scale if scale < 1 and not decimals else 0.0
    return 0.5 * scale * 10.0 ** -len(decimals)
