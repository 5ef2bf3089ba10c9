"""The matrices of a study as an Excel file: the same study gives the same bytes."""

from __future__ import annotations

from datetime import datetime
from importlib.metadata import version
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.cases.kept_values import kept_or_made
from torquerig.reporting.workbook import sheets
from torquerig.reporting.workbook.kesselring_sheet import write_kesselring
from torquerig.reporting.workbook.trace_sheets import write_catalog_values, write_trace
from torquerig.study.trace import traced_combinations

if TYPE_CHECKING:
    from torquerig.study.results import StudyRuns
    from torquerig.study.scoring import Decided
    from torquerig.study.verdict import Verdict

CREATED = datetime(2000, 1, 1)  # a fixed date, so that equal studies give equal files


def write_workbook(path: Path, runs: StudyRuns, decided: Decided, verdict: Verdict) -> None:
    """Write ranking, shares, elimination, Pugh, Kesselring, assumptions and all calculations, one sheet each.

    The weights of the Kesselring sheet are meant to be changed: totals, T/T_max and ranks are formulas. Their present
    values are stored too, for viewers that do not calculate. A workbook of the same drives and settings is kept.
    """
    content = (list(runs.row_keys.items()), runs.study.settings, version("xlsxwriter"))
    made = kept_or_made(runs.kept, "workbook", content, lambda: _workbook(runs, decided, verdict), classes=())
    path.write_bytes(made)


def _workbook(runs: StudyRuns, decided: Decided, verdict: Verdict) -> bytes:
    import xlsxwriter

    from torquerig.reporting.workbook.known_formulas import KnownFormulas

    archive = BytesIO()  # the library leaves an open archive behind where the disk is full
    book = xlsxwriter.Workbook(archive, {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False})
    book.set_properties({"title": "torquerig study", "created": CREATED})
    looks = formats(book)
    sheets.write_ranking(book.add_worksheet("Ranking"), looks, decided)
    sheets.write_shares(book.add_worksheet("Shares"), looks, runs)
    sheets.write_elimination(book.add_worksheet("Elimination"), looks, decided.chart, decided.requirements)
    sheets.write_pugh(book.add_worksheet("Pugh", KnownFormulas), looks, decided.pugh)
    write_kesselring(book.add_worksheet("Kesselring", KnownFormulas), looks, decided.overall)
    sheets.write_assumptions(book.add_worksheet("Assumptions"), looks, runs)
    traced = traced_combinations(decided, verdict)
    write_trace(book.add_worksheet("Trace"), looks, traced)
    write_catalog_values(book.add_worksheet("Catalog"), looks, traced)
    book.close()
    return archive.getvalue()


def formats(book: Any) -> dict[str, Any]:
    """Return the looks of cells by name."""
    given = {
        "head": {"bold": True, "text_wrap": True, "valign": "top", "bg_color": "#F1F4F7", "bottom": 1},
        "bold": {"bold": True},
        "wrap": {"text_wrap": True, "valign": "top"},
        "three": {"num_format": "0.000"},
        "four": {"num_format": "0.0000"},
        "one": {"num_format": "0.0"},
        "mark": {"align": "center"},
        "unknown": {"align": "right", "bg_color": "#FDF0C4"},
        "hand": {"num_format": "0.000", "bold": True, "bg_color": "#E3D7F2"},
        "entry": {"bg_color": "#FFF2CC", "border": 1},
        "guess": {"num_format": "0.000", "italic": True},
        "weight": {"num_format": "0.###", "bold": True, "bg_color": "#FFF2CC", "border": 1},
        "+": {"align": "center", "bg_color": "#D5ECD4"},
        "-": {"align": "center", "bg_color": "#F6CFCA"},
        "?": {"align": "center", "bg_color": "#FDF0C4"},
        "!": {"align": "center", "bg_color": "#F9DCB0"},
        "S": {"align": "center", "bg_color": "#ECEFF1"},
    }
    return {name: book.add_format(look) for name, look in given.items()}
