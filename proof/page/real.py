"""Real recordings with known answers: held-out residuals of the baseline and of each step of the diagnosis."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from torquerig.reporting.layout import Cell, Table, number, words
from torquerig.reporting.matrix.chapters import Chapter

REQUIRED = {
    "emps": "68.6 to 5.1 with dry friction, 4.3 by direction; a ripple of 400 cycles/m stays unexplained",
    "laas": "0.1395 to 0.052 with order 72, 0.042 with 18 and 36",
    "brfd": "1.61 to 0.40 with presliding, 0.30 with backlash",
}


def real_chapters(folder: Path | None, *, progress: Callable[[str], None] = lambda _: None) -> tuple[Chapter, ...]:
    """Return the chapter of the real recordings in ``folder``, one subfolder per source; none without a folder.

    ``progress`` receives the name of each rig. A rig without recordings has a row with the error.
    """
    if folder is None:
        return ()
    from proof.real.figures import RIGS
    from proof.real.public import VARIABLE

    os.environ[VARIABLE] = str(folder)
    rows = []
    for rig in RIGS:
        progress(rig)
        rows += _rows(rig)
    table = Table(
        caption="Rms residual on held-out recordings", head=("", "model", "accepted", "held-out residual", "unit"),
        rows=tuple(rows), note="Required: " + "; ".join(f"{rig} {text}" for rig, text in REQUIRED.items()) + ".",
    )  # fmt: skip
    return (Chapter(anchor="real", title="Real recordings", tables=(table,)),)


def _rows(rig: str) -> list[tuple[Cell, ...]]:
    from proof.real.figures import ERROR_MEASURES, diagnosed, figures

    try:
        outcome = diagnosed(rig)
    except Exception as wrong:
        return [words(rig, f"no diagnosis: {wrong}", "", "", "")]
    rows: list[tuple[Cell, ...]] = []
    verdict = outcome.diagnosis.verdict.replace("_", " ")
    for each in figures(rig, outcome):
        name = words(rig if not rows else "", f"{each.model}; verdict {verdict}" if not rows else each.model)
        error = number(f"{each.held_out:.4g}")
        rows.append((*name, Cell(text="yes" if each.named else ""), error, Cell(text=ERROR_MEASURES[rig].unit)))
    return rows
