"""Lint of the weights: they should sum to 1."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet


def weights_not_one(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find weights that do not sum to 1: a row may have been lost."""
    total = sum(table.weights)
    is_complete = abs(total - 1) < 1e-9 or abs(total - 100) < 1e-7 or {*table.weights} == {1.0}  # per cent; unweighted
    if table.method is not Method.KESSELRING or is_complete:
        return []
    ideal = table.profile.p_max * total
    gap = 1 - total
    why = (
        f"a weight of {gap:+.2g} is missing; a criterion may be missing" if gap > 0
        else "the sums are not on the points scale, or a weight is too large"
    )  # fmt: skip
    so = f", so that the ideal gets {ideal:g} of {table.profile.p_max:g}" if table.profile.stated else ""
    return [
        about(
            table,
            lint="weights do not sum to 1",
            table=table.name,
            what=f"the weights sum to {total:g}{so}",
            why=why,
            remedy="add the missing criterion or divide by the sum; T/T_max and the ranks do not change",
        )
    ]
