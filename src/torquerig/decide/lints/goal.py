"""Whether the stated goal is asked for."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.sheet import UNKNOWN, Book, Method, Sheet


def goal_without_criterion(sheet: Sheet, book: Book) -> list[Finding]:
    """Find rankings without a row for the stated goal, or with nothing known in it.

    Eliminations are left out: the goal ranks, it need not be a demand.
    """
    if sheet.method is Method.ELIMINATION or not book.goal_words:
        return []
    rows = [row for row in sheet.rows if any(word.lower() in row.criterion.lower() for word in book.goal_words)]
    if not rows:
        return [
            about(
                sheet,
                lint="the goal has no criterion",
                table=sheet.name,
                what=f"no row asks for the stated goal, {book.goal}",
                why="the winner is chosen by everything but the purpose of the choice",
                remedy=f"add a criterion for {book.goal} with its weight",
            )
        ]
    return [
        about(
            row,
            lint="the goal is unknown",
            table=sheet.name,
            what=f"{row.criterion!r} is ? for everybody",
            why=f"the table says nothing about the stated goal, {book.goal}",
            remedy="measure or simulate it before ranking",
        )
        for row in rows
        if set(row.entries) == {UNKNOWN}
    ]
