"""Whether one thing is counted twice."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.sheet import UNKNOWN, Book, Method, Row, Sheet, canonical

STRONG = 0.9
FEWEST_PAIRS = 4


def identical_rows(sheet: Sheet, book: Book) -> list[Finding]:
    """Find pairs of rows with the same entries that do tell alternatives apart."""
    return [
        about(
            second,
            lint="identical rows",
            table=sheet.name,
            what=f"{first.criterion!r} and {second.criterion!r} have the same entries",
            why="one property is counted twice",
            remedy="keep one of them, or say what the second adds",
        )
        for first, second in combinations([row for row in sheet.rows if row.varies], 2)
        if _same(first, second)
    ]


def correlated_rows(sheet: Sheet, book: Book) -> list[Finding]:
    """Find pairs of rows that rise together (Pearson r of at least 0.9 over at least four known pairs).

    Only rankings are looked at; a strong negative correlation is a trade-off, not double counting. With few
    alternatives a high r is weak evidence, so the finding says on how many pairs it rests.
    """
    if sheet.method is Method.ELIMINATION:
        return []
    found = []
    for first, second in combinations(sheet.rows, 2):
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
                    table=sheet.name,
                    what=f"{first.criterion!r} and {second.criterion!r} rise together "
                    f"(r = {r:.2f} over {len(known)} alternatives)",
                    why="what lies behind both may be counted twice",
                    remedy="check that both ask for different things, or share one weight between them",
                )
            )
    return found


def _same(first: Row, second: Row) -> bool:
    mine, other = ([canonical(entry) for entry in row.entries] for row in (first, second))
    return mine == other and set(mine) != {UNKNOWN}
