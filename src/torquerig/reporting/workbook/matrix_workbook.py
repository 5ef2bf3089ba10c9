"""A decision matrix as Excel file with entries and formulas, which torquerig matrix reads."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.decide.matrix_io.excel_layout import CRITERIA, FACTS, SETTINGS, SOURCES
from torquerig.reporting.workbook import entry_sheets as entries
from torquerig.reporting.workbook.answer_sheets import write_answers, write_ask, write_findings
from torquerig.reporting.workbook.kesselring_sheet import write_kesselring
from torquerig.reporting.workbook.links import links_of
from torquerig.reporting.workbook.sheets import write_elimination, write_pugh
from torquerig.reporting.workbook.study_workbook import CREATED, formats

if TYPE_CHECKING:
    from torquerig.decide.matrix_analysis import MatrixAnalysis


def write_matrix_workbook(path: Path, worked: MatrixAnalysis) -> None:
    """Write the four sheets that a person fills in, and those that follow from them.

    Criteria, Facts, Settings and Sources are entries, coloured; ``torquerig matrix FILE.xlsx`` reads them back. On the
    sheet Kesselring every number is a formula over them: a changed weight, fact or value function changes points,
    totals and ranks at once. Verdict, elimination, Pugh and missing values are those of the last run of the program.
    """
    import xlsxwriter

    archive = BytesIO()  # the library leaves an open archive behind where the disk is full
    book = xlsxwriter.Workbook(archive, {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False})
    book.set_properties({"title": worked.case.matrix.name, "created": CREATED})
    looks = formats(book)
    made: dict[str, Any] = {
        name: book.add_worksheet(name)
        for name in ("Verdict", CRITERIA, FACTS, SETTINGS, SOURCES, "Kesselring", "Elimination", "Pugh", "Ask", "Lints")
    }
    write_answers(made["Verdict"], looks, worked)
    entries.write_criteria(made[CRITERIA], looks, worked.case)
    entries.write_facts(made[FACTS], looks, worked.case)
    entries.write_settings(made[SETTINGS], looks, worked.case)
    entries.write_sources(made[SOURCES], looks, worked.case)
    write_kesselring(made["Kesselring"], looks, worked.overall, links=links_of(worked))
    write_elimination(made["Elimination"], looks, worked.chart, worked.case.matrix, of="alternative")
    write_pugh(made["Pugh"], looks, worked.pugh)
    write_ask(made["Ask"], looks, worked)
    write_findings(made["Lints"], looks, worked.findings)
    book.close()
    path.write_bytes(archive.getvalue())
