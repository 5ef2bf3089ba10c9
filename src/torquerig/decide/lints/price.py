"""Lint of the price: it belongs to the economic rating."""

from __future__ import annotations

from torquerig.decide.criterion import Kind
from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet
from torquerig.decide.matrix_io.recompute import technical_shares


def price_in_technical_rating(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find economic rows that are in one total with technical ones."""
    weighted = [row for row in table.rows if row.weight]
    economic = [row for row in weighted if row.kind is Kind.ECONOMIC]
    if table.method is not Method.KESSELRING or not economic or len(economic) == len(weighted):
        return []
    shares = zip(table.alternatives, technical_shares(table), strict=True)
    alone = ", ".join(f"{name} {share:.2f}" for name, share in shares)
    return [
        about(
            economic[0],
            lint="price inside the technical rating",
            table=table.name,
            what=f"{quoted([row.criterion for row in economic])} is added up with technical properties",
            why=f"a low price hides technical weaknesses; the technical rating alone gives T/T_max {alone}",
            remedy="rate technical and economic criteria separately (VDI 2225: x and y)",
        )
    ]
