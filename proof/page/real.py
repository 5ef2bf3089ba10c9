"""Real recordings with known answers: held-out errors of the baseline and of each step of the diagnosis."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from torquerig.reporting.layout import Cell, Table, number, words
from torquerig.reporting.matrix.chapters import Chapter

ASKED = {
    "emps": "68.6 to 5.1 with dry friction, 4.3 by direction; a ripple of 400 cycles/m left unexplained",
    "laas": "0.1395 to 0.052 with order 72, 0.042 with 18 and 36",
    "brfd": "1.61 to 0.40 with presliding, 0.30 with backlash",
}


def real_chapters(folder: Path | None, *, begin: Callable[[str], None] = lambda _: None) -> tuple[Chapter, ...]:
    """Return the chapter of the real recordings in ``folder``, one subfolder per source; none where none was named.

    A rig whose recordings are not there is said so; ``begin`` is told the name of each rig.
    """
    if folder is None:
        return ()
    from proof.real.figures import RIGS
    from proof.real.public import VARIABLE

    os.environ[VARIABLE] = str(folder)
    rows = []
    for rig in RIGS:
        begin(rig)
        rows += _rows(rig)
    table = Table(
        caption="Error on recordings that no fit has seen", head=("", "model", "named", "held-out error", "counted in"),
        rows=tuple(rows), note="Asked: " + "; ".join(f"{rig} {told}" for rig, told in ASKED.items()) + ".",
    )  # fmt: skip
    return (Chapter(anchor="real", title="Real recordings", tables=(table,)),)


def _rows(rig: str) -> list[tuple[Cell, ...]]:
    from proof.real.figures import TOLD, diagnosed, figures

    try:
        outcome = diagnosed(rig)
    except Exception as wrong:
        return [words(rig, f"no diagnosis: {wrong}", "", "", "")]
    rows: list[tuple[Cell, ...]] = []
    verdict = outcome.diagnosis.verdict.replace("_", " ")
    for each in figures(rig, outcome):
        name = words(rig if not rows else "", f"{each.model}; verdict {verdict}" if not rows else each.model)
        error = number(f"{each.held_out:.4g}")
        rows.append((*name, Cell(text="yes" if each.named else ""), error, Cell(text=TOLD[rig].unit)))
    return rows
