"""Whether the price is rated where it belongs."""

from __future__ import annotations

from torquerig.decide.criterion import Kind
from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.recompute import technical_shares
from torquerig.decide.matrix_io.sheet import Book, Method, Sheet


def price_in_technical_rating(sheet: Sheet, book: Book) -> list[Finding]:
    """Find economic rows weighed together with technical ones in one total."""
    weighted = [row for row in sheet.rows if row.weight]
    economic = [row for row in weighted if row.kind is Kind.ECONOMIC]
    if sheet.method is not Method.KESSELRING or not economic or len(economic) == len(weighted):
        return []
    shares = zip(sheet.alternatives, technical_shares(sheet), strict=True)
    alone = ", ".join(f"{name} {share:.2f}" for name, share in shares)
    return [
        about(
            economic[0],
            lint="price inside the technical rating",
            table=sheet.name,
            what=f"{quoted([row.criterion for row in economic])} is added up with technical properties",
            why=f"a cheap weakness looks like a merit; technically alone T/T_max is {alone}",
            remedy="rate technical and economic apart and look at both (VDI 2225: x and y)",
        )
    ]
