"""Whether each row tells the alternatives apart."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.sheet import Book, Method, Sheet


def rows_without_difference(sheet: Sheet, book: Book) -> list[Finding]:
    """Find the rows of a ranking in which all alternatives are judged the same (a demand may be met by all)."""
    if sheet.method is Method.ELIMINATION or len(sheet.alternatives) < 2:
        return []
    flat = [row for row in sheet.rows if not row.varies]
    if not flat:
        return []
    deciding = len(sheet.rows) - len(flat)
    return [
        about(
            flat[0],
            lint="rows that do not discriminate",
            table=sheet.name,
            what=f"{len(flat)} of {len(sheet.rows)} rows are the same for all: "
            f"{quoted([row.criterion for row in flat])}",
            why=f"the ranking rests on the other {deciding}",
            remedy="judge these rows finer (numbers instead of marks), or leave them out",
        )
    ]


def rows_all_minus(sheet: Sheet, book: Book) -> list[Finding]:
    """Find the rows in which everybody has ``-``."""
    hit = [row for row in sheet.rows if row.entries and set(row.entries) == {"-"}]
    if sheet.method is Method.ELIMINATION:
        why = "under the strict rule nobody survives it"
        remedy = "if it is a demand, all are out: check the demand; if it is a wish, take it out of this table"
    else:
        why = "it only says that the datum is better, not which of the others"
        remedy = "state by how much each is worse, so that the row can tell them apart"
    return [
        about(
            row,
            lint="everybody has -",
            table=sheet.name,
            what=f"all {len(row.entries)} alternatives have - under {row.criterion!r}",
            why=why,
            remedy=remedy,
        )
        for row in hit
    ]
