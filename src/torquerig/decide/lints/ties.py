"""Whether the table tells its first two apart."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.recompute import recomputed_kesselring, recomputed_pugh
from torquerig.decide.matrix_io.sheet import UNKNOWN, Book, Method, Sheet
from torquerig.decide.ranks import TIE


def winners_tie(sheet: Sheet, book: Book) -> list[Finding]:
    """Find known sums that are equal in front (unknown cells would make it a question of facts, not a tie)."""
    if sheet.method is Method.ELIMINATION or len(sheet.alternatives) < 2:
        return []
    if sheet.method is Method.PUGH:
        sums = recomputed_pugh(sheet).net_certain[1:].astype(float)
    else:
        sums = recomputed_kesselring(sheet).total
    first = [name for name, one in zip(sheet.alternatives, sums.tolist(), strict=True) if one >= sums.max() - TIE]
    if len(first) < 2 or any(UNKNOWN in sheet.column(name) for name in first):
        return []
    return [
        about(
            sheet,
            lint="a tie in front",
            table=sheet.name,
            what=f"{quoted(first)} have the same sum {sums.max():.4g}",
            why="the table does not decide between them; whoever is named first is so by chance",
            remedy="let them share the rank, and add what tells them apart or judge finer",
        )
    ]
