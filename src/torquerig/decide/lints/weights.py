"""Lint of the weights: they should sum to 1."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet


def weights_not_one(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find weights that do not sum to 1: a row may have been lost."""
    total = sum(table.weights)
    if table.method is not Method.KESSELRING or abs(total - 1) < 1e-9:
        return []
    ideal = table.profile.p_max * total
    return [
        about(
            table,
            lint="weights do not sum to 1",
            table=table.name,
            what=f"the weights sum to {total:g}, so that the ideal gets {ideal:g} of {table.profile.p_max:g}",
            why=f"a weight of {1 - total:+.2g} is missing; a criterion may be missing",
            remedy="add the missing criterion or divide by the sum; T/T_max and the ranks do not change",
        )
    ]
