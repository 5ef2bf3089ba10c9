"""Lints of unknown entries: a ``?`` must stay unknown."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.matrix_table import UNKNOWN, MatrixTable, Method, TableSet
from torquerig.decide.matrix_io.recompute import recomputed_pugh


def unknown_counted_as_zero(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find printed net sums that omit ``?``, which counts it as ``S``."""
    if table.method is not Method.PUGH or not table.sums:
        return []
    result = recomputed_pugh(table)
    hit = [
        f"{name} {printed:g} instead of {result.net_low[place]}..{result.net_high[place]}"
        for place, (name, printed) in enumerate(zip(table.alternatives, table.sums, strict=True), start=1)
        if UNKNOWN in table.column(name) and printed is not None and printed == result.net_certain[place]
    ]
    if not hit:
        return []
    return [
        about(
            table,
            lint="? counted as 0",
            table=table.name,
            what=f"the sums omit ?: {', '.join(hit)}",
            why="an unknown value is counted as equal to the baseline",
            remedy="print the interval, or find the missing facts",
        )
    ]


def unknown_passed_as_yes(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find alternatives that pass an elimination with an open requirement."""
    if table.method is not Method.ELIMINATION:
        return []
    passed = [name for name, yes in zip(table.alternatives, table.passed, strict=True) if yes]
    hit = [name for name in passed if UNKNOWN in table.column(name)]
    if not hit:
        return []
    return [
        about(
            table,
            lint="? passed as yes",
            table=table.name,
            what=f"{len(hit)} of the {len(passed)} that pass have a ? ({quoted(hit)})",
            why="an open requirement is not met",
            remedy="mark them as open, and get the missing facts",
        )
    ]
