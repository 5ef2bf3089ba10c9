"""Whether the weights sum to 1."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.sheet import Book, Method, Sheet


def weights_not_one(sheet: Sheet, book: Book) -> list[Finding]:
    """Find weights that do not sum to 1: a row may have been lost."""
    total = sum(sheet.weights)
    if sheet.method is not Method.KESSELRING or abs(total - 1) < 1e-9:
        return []
    ideal = sheet.profile.p_max * total
    return [
        about(
            sheet,
            lint="weights do not sum to 1",
            table=sheet.name,
            what=f"the weights sum to {total:g}, so that the ideal gets {ideal:g} of {sheet.profile.p_max:g}",
            why=f"a weight of {1 - total:+.2g} is unaccounted for; a criterion may be missing",
            remedy="add what is missing or divide by the sum; T/T_max and the ranks stay as they are",
        )
    ]
