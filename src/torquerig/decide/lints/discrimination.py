"""Lints of rows that do not distinguish the alternatives."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet


def rows_without_difference(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find the rows of a ranking in which all alternatives have the same entry (a requirement may be met by all)."""
    if table.method is Method.ELIMINATION or len(table.alternatives) < 2:
        return []
    flat = [row for row in table.rows if not row.varies]
    if not flat:
        return []
    deciding = len(table.rows) - len(flat)
    return [
        about(
            flat[0],
            lint="rows that do not discriminate",
            table=table.name,
            what=f"{len(flat)} of {len(table.rows)} rows are the same for all: "
            f"{quoted([row.criterion for row in flat])}",
            why=f"the ranking depends on the other {deciding}",
            remedy="rate these rows with finer steps (numbers instead of marks), or omit them",
        )
    ]


def rows_all_minus(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find the rows in which all alternatives have ``-``."""
    hit = [row for row in table.rows if row.entries and {*row.entries} <= {"-", "--"}]
    if table.method is Method.ELIMINATION:
        why = "by the strict rule it eliminates every alternative"
        remedy = "check the requirement, which eliminates all; if it is a wish, remove it from this table"
    else:
        why = "it shows that the baseline is better, but does not compare the others"
        remedy = "state by how much each is worse"
    return [
        about(
            row,
            lint="all have -",
            table=table.name,
            what=f"all {len(row.entries)} alternatives have - under {row.criterion!r}",
            why=why,
            remedy=remedy,
        )
        for row in hit
    ]
