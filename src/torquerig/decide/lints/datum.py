"""Whether the datum is treated as a datum."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.recompute import recomputed_pugh
from torquerig.decide.matrix_io.sheet import Book, Method, Sheet


def plus_against_having_datum(sheet: Sheet, book: Book) -> list[Finding]:
    """Find ``+`` against a datum that has the property itself, where the best possible is ``S``."""
    found = []
    for row in sheet.rows:
        hit = [name for name, entry in zip(sheet.alternatives, row.entries, strict=True) if entry == "+"]
        if sheet.method is not Method.PUGH or not row.datum_has or not hit:
            continue
        corrected = recomputed_pugh(sheet, correct_datum=True)
        nets = ", ".join(f"{net:g}" for net in corrected.net_certain[1:].tolist())
        found.append(
            about(
                row,
                lint="+ against a datum that has it",
                table=sheet.name,
                what=f"{row.criterion!r} is + for {quoted(hit)}, but {sheet.datum} has it already",
                why=f"the best possible is S; corrected, the nets are {nets}",
                remedy="write S for those that have it too and - for those that have not",
            )
        )
    return found


def datum_without_rank(sheet: Sheet, book: Book) -> list[Finding]:
    """Find printed ranks that leave out a datum which would stand above some of the alternatives."""
    if sheet.method is not Method.PUGH or not any(rank is not None for rank in sheet.ranks):
        return []
    result = recomputed_pugh(sheet)
    behind = int((result.net_certain < 0).sum())
    if not behind:
        return []
    return [
        about(
            sheet,
            lint="the datum is not ranked",
            table=sheet.name,
            what=f"{sheet.datum} has no rank, but outranks {behind} of {len(sheet.alternatives)}",
            why="a buyer may keep what is there; the table hides that this is often the better choice",
            remedy=f"rank {sheet.datum} with the others (net 0, rank {int(result.ranks[0])})",
        )
    ]


def one_datum_only(book: Book) -> list[Finding]:
    """Find several Pugh tables that all use the same datum."""
    sheets = [sheet for sheet in book.audited if sheet.method is Method.PUGH]
    if len(sheets) < 2 or len({sheet.datum for sheet in sheets}) > 1:
        return []
    return [
        about(
            sheets[0],
            lint="the datum never changes",
            table=", ".join(sheet.name for sheet in sheets),
            what=f"all {len(sheets)} tables compare with {sheets[0].datum}",
            why="net totals depend on the datum; a ranking that only one datum gives is not one",
            remedy="run the table again with its winner as datum until the datum stands",
        )
    ]
