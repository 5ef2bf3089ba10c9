"""Lint of ties: two alternatives with the highest sum."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.matrix_table import UNKNOWN, MatrixTable, Method, TableSet
from torquerig.decide.matrix_io.recompute import recomputed_kesselring, recomputed_pugh
from torquerig.decide.ranks import TIE


def winners_tie(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find equal highest sums of known cells (with unknown cells, the result is open and no tie)."""
    if table.method is Method.ELIMINATION or len(table.alternatives) < 2:
        return []
    if table.method is Method.PUGH:
        sums = recomputed_pugh(table).net_certain[1:].astype(float)
    else:
        sums = recomputed_kesselring(table).total
    first = [name for name, one in zip(table.alternatives, sums.tolist(), strict=True) if one >= sums.max() - TIE]
    if len(first) < 2 or any(UNKNOWN in table.column(name) for name in first):
        return []
    return [
        about(
            table,
            lint="tie for the first rank",
            table=table.name,
            what=f"{quoted(first)} have the same sum {sums.max():.4g}",
            why="the table does not decide between them; their order is arbitrary",
            remedy="give them the same rank, and add a criterion that distinguishes them or use finer points",
        )
    ]
