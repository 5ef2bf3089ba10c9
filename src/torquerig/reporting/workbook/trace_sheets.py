"""Calculation of every cell of a study as two sheets: cells, and the catalog values behind them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from torquerig.reporting.workbook.sheets import write_head

if TYPE_CHECKING:
    from torquerig.decide.trace import CellTrace
    from torquerig.study.trace import TracedDrive

Looks = dict[str, Any]
STEPS = (
    "metric", "value", "missing", "requirement", "Pugh", "value function", "points", "weight", "total", "decision",
)  # fmt: skip
"""The steps of a trace, a column each; the catalog values are on a separate sheet."""


def write_trace(sheet: Any, looks: Looks, traced: Sequence[TracedDrive]) -> None:
    """Write a row per cell: requirements of each drive once, criteria of each combination."""
    wide = {0: 46, 1: 22, 2: 12, 3: 60, 4: 28, 5: 40, 6: 44, 8: 44, 9: 30, 10: 44, 11: 40, 12: 60}
    write_head(sheet, looks, ["drive | filter", "criterion or requirement", "catalog values", *STEPS], wide=wide)
    seen: set[str] = set()
    row = 0
    for one in traced:
        cells = (*one.criteria, *(() if one.drive in seen else one.requirements))
        seen.add(one.drive)
        for trace in cells:
            row += 1
            _cell_row(sheet, row, trace)


def write_catalog_values(sheet: Any, looks: Looks, traced: Sequence[TracedDrive]) -> None:
    """Write a row per drive and catalog value: value, evidence, source, and the cells that use it."""
    head = ["drive", "catalog value", "known", "evidence", "source", "used for"]
    write_head(sheet, looks, head, wide={0: 26, 1: 44, 2: 46, 3: 9, 4: 60, 5: 60})
    seen: set[str] = set()
    row = 0
    for one in traced:
        if one.drive in seen:
            continue
        seen.add(one.drive)
        for origin, used in one.origins:
            row += 1
            texts = (one.drive, origin.name, origin.shown, origin.evidence, origin.source, ", ".join(used))
            for column, text in enumerate(texts):
                sheet.write_string(row, column, text)


def _cell_row(sheet: Any, row: int, trace: CellTrace) -> None:
    sheet.write_string(row, 0, trace.alternative)
    sheet.write_string(row, 1, trace.criterion)
    sheet.write_number(row, 2, len(trace.texts("catalog")))
    for column, label in enumerate(STEPS, start=3):
        if texts := trace.texts(label):
            sheet.write_string(row, column, "; ".join(texts))
