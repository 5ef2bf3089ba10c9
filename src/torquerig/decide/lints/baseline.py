"""Lints of the baseline of a Pugh table."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet
from torquerig.decide.matrix_io.recompute import recomputed_pugh


def plus_against_having_baseline(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find ``+`` against a baseline that has the property too, where the best possible is ``S``."""
    found = []
    for row in table.rows:
        hit = [name for name, entry in zip(table.alternatives, row.entries, strict=True) if entry in ("+", "++")]
        if table.method is not Method.PUGH or not row.baseline_has or not hit:
            continue
        corrected = recomputed_pugh(table, correct_baseline=True)
        nets = ", ".join(f"{net:g}" for net in corrected.net_certain[1:].tolist())
        found.append(
            about(
                row,
                lint="+ against a baseline that has it",
                table=table.name,
                what=f"{row.criterion!r} is + for {quoted(hit)}, but {table.baseline} has it already",
                why=f"the best possible is S; corrected, the nets are {nets}",
                remedy="write S for those that have it too and - for the others",
            )
        )
    return found


def baseline_without_rank(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find printed ranks that omit a baseline which would rank above some of the alternatives."""
    if table.method is not Method.PUGH or not any(rank is not None for rank in table.ranks):
        return []
    result = recomputed_pugh(table)
    behind = int((result.net_certain < 0).sum())
    if not behind:
        return []
    return [
        about(
            table,
            lint="the baseline is not ranked",
            table=table.name,
            what=f"{table.baseline} has no rank, but outranks {behind} of {len(table.alternatives)}",
            why="keeping the baseline is an option too; the table hides that it is often the better choice",
            remedy=f"rank {table.baseline} with the others (net 0, rank {int(result.ranks[0])})",
        )
    ]


def one_baseline_only(table_set: TableSet) -> list[Finding]:
    """Find several Pugh tables that all use the same baseline."""
    tables = [table for table in table_set.audited if table.method is Method.PUGH]
    if len(tables) < 2 or len({table.baseline for table in tables}) > 1:
        return []
    return [
        about(
            tables[0],
            lint="the baseline never changes",
            table=", ".join(table.name for table in tables),
            what=f"all {len(tables)} tables compare with {tables[0].baseline}",
            why="net totals depend on the baseline; a ranking that holds for one baseline only is not reliable",
            remedy="repeat the table with its winner as baseline until the baseline is stable",
        )
    ]
