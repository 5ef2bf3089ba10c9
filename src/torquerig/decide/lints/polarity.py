"""Lints of the direction of a criterion."""

from __future__ import annotations

import re

from torquerig.decide.criterion import Better
from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.matrix_table import MatrixTable, TableSet

NEEDS = frozenset({"need", "needs", "needed", "require", "requires", "required"})
NEGATIONS = frozenset({"no", "not", "without", "none", "never", "unneeded"})
DEFECTS = frozenset({
    "backlash", "cost", "costs", "delay", "disturbance", "drag", "effort", "error", "errors", "friction", "loss",
    "losses", "mass", "modifications", "noise", "play", "price", "ripple", "risk", "vibration", "wear", "weight"
})  # fmt: skip
MERITS = frozenset({
    "accuracy", "availability", "bandwidth", "cheapness", "efficiency", "fit", "improvement", "life", "lifetime",
    "little", "low", "margin", "quality", "reduced", "reduction", "reliability", "reserve", "saved", "saving",
    "savings", "small", "stiffness"
})  # fmt: skip


def polarity_unclear(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find criteria whose name states a need, so that a ``+`` may mean "needs it" or "has it"."""
    return [
        about(
            row,
            lint="unclear polarity",
            table=table.name,
            what=f"{row.criterion!r} does not state whether a high mark means that it is needed or that it is present",
            why="the same mark can be read as a merit and as a defect",
            remedy="word it as a merit: what a good alternative has or does",
        )
        for row in table.rows
        if row.better is None and _words(row.criterion) & NEEDS and not _words(row.criterion) & NEGATIONS
    ]


def polarity_against_the_name(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find criteria that are named as a defect and counted as a merit, or the other way round."""
    found = []
    for row in table.rows:
        words = _words(row.criterion)
        defect, merit = words & DEFECTS and not words & MERITS, words & MERITS and not words & DEFECTS
        if not ((row.better is Better.MORE and defect) or (row.better is Better.LESS and merit)):
            continue
        found.append(
            about(
                row,
                lint="polarity against the name",
                table=table.name,
                what=f"{row.criterion!r} names a {'defect' if defect else 'merit'}, but {row.better} is better",
                why="if the direction is wrong, the worst alternative gets the most points",
                remedy="change better:, or word the criterion as a merit",
            )
        )
    return found


def _words(name: str) -> frozenset[str]:
    return frozenset(re.findall(r"[a-z]+", name.lower()))
