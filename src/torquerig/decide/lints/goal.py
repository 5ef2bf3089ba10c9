"""Lint of the stated goal: a criterion must rate it."""

from __future__ import annotations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.matrix_table import UNKNOWN, MatrixTable, Method, TableSet


def goal_without_criterion(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find rankings without a row for the stated goal, or with ``?`` only in it.

    Eliminations are not checked: the goal ranks, it need not be a requirement.
    """
    if table.method is Method.ELIMINATION or not table_set.goal_words:
        return []
    rows = [row for row in table.rows if any(word.lower() in row.criterion.lower() for word in table_set.goal_words)]
    if not rows:
        return [
            about(
                table,
                lint="the goal has no criterion",
                table=table.name,
                what=f"no row rates the stated goal, {table_set.goal}",
                why="the choice does not depend on its purpose",
                remedy=f"add a criterion for {table_set.goal} with its weight",
            )
        ]
    return [
        about(
            row,
            lint="the goal is unknown",
            table=table.name,
            what=f"{row.criterion!r} is ? for all alternatives",
            why=f"the table contains nothing about the stated goal, {table_set.goal}",
            remedy="measure or simulate it before ranking",
        )
        for row in rows
        if set(row.entries) == {UNKNOWN}
    ]
