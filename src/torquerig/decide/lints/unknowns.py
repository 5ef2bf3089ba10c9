"""Whether a ``?`` stays a ``?``."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about, quoted
from torquerig.decide.matrix_io.recompute import recomputed_pugh
from torquerig.decide.matrix_io.sheet import UNKNOWN, Book, Method, Sheet


def unknown_counted_as_zero(sheet: Sheet, book: Book) -> list[Finding]:
    """Find printed net sums that left ``?`` out, which is to count it as ``S``."""
    if sheet.method is not Method.PUGH or not sheet.sums:
        return []
    result = recomputed_pugh(sheet)
    hit = [
        f"{name} {printed:g} instead of {result.net_low[place]}..{result.net_high[place]}"
        for place, (name, printed) in enumerate(zip(sheet.alternatives, sheet.sums, strict=True), start=1)
        if UNKNOWN in sheet.column(name) and printed is not None and printed == result.net_certain[place]
    ]
    if not hit:
        return []
    return [
        about(
            sheet,
            lint="? counted as 0",
            table=sheet.name,
            what=f"the sums leave ? out: {', '.join(hit)}",
            why="not knowing is printed as being no different from the datum",
            remedy="print the interval, or find the missing facts",
        )
    ]


def unknown_passed_as_yes(sheet: Sheet, book: Book) -> list[Finding]:
    """Find alternatives that pass an elimination with a demand unanswered."""
    if sheet.method is not Method.ELIMINATION:
        return []
    passed = [name for name, yes in zip(sheet.alternatives, sheet.passed, strict=True) if yes]
    hit = [name for name in passed if UNKNOWN in sheet.column(name)]
    if not hit:
        return []
    return [
        about(
            sheet,
            lint="? passed as yes",
            table=sheet.name,
            what=f"{len(hit)} of the {len(passed)} that pass have a ? ({quoted(hit)})",
            why="an unanswered demand is not a fulfilled one",
            remedy="mark them open, and ask for the missing facts",
        )
    ]
