"""Lints of duplicate rows: one property counted twice."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.matrix_table import UNKNOWN, MatrixTable, Method, Row, TableSet, canonical

STRONG = 0.9  # [1] Pearson r from which rows count as strongly correlated
FEWEST_PAIRS = 4  # fewer pairs often give a high r by random error


def identical_rows(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find pairs of rows with the same entries that distinguish alternatives."""
    return [
        about(
            second,
            lint="identical rows",
            table=table.name,
            what=f"{first.criterion!r} and {second.criterion!r} have the same entries",
            why="one property is counted twice",
            remedy="keep one of them, or state what the second adds",
        )
        for first, second in combinations([row for row in table.rows if row.varies], 2)
        if _same(first, second)
    ]


def correlated_rows(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find pairs of positively correlated rows (Pearson r of at least 0.9 over at least four known pairs).

    Only rankings are checked; a strong negative correlation is a trade-off, not double counting. With few
    alternatives a high r is weak evidence, so that the finding states the number of pairs.
    """
    if table.method is Method.ELIMINATION:
        return []
    found = []
    for first, second in combinations(table.rows, 2):
        pairs = [pair for pair in zip(first.numbers, second.numbers, strict=True) if None not in pair]
        known = np.array(pairs, dtype=float).reshape(-1, 2)
        if len(known) < FEWEST_PAIRS or np.ptp(known, axis=0).min() == 0 or _same(first, second):
            continue
        r = float(np.corrcoef(known.T)[0, 1])
        if r >= STRONG - 1e-12:
            found.append(
                about(
                    second,
                    lint="strongly correlated rows",
                    table=table.name,
                    what=f"{first.criterion!r} and {second.criterion!r} are correlated "
                    f"(r = {r:.2f} over {len(known)} alternatives)",
                    why="a common cause may be counted twice",
                    remedy="check that they rate different properties, or divide one weight between them",
                )
            )
    return found


def _same(first: Row, second: Row) -> bool:
    mine, other = ([canonical(entry) for entry in row.entries] for row in (first, second))
    return mine == other and set(mine) != {UNKNOWN}
