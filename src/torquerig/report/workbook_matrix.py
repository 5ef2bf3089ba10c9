"""One's own matrix as an Excel file that is filled in, calculates, and can be read again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from torquerig.decide.sheet_layout import CRITERIA, FACTS, SETTINGS, SOURCES
from torquerig.decide.working import WorkedOut
from torquerig.report import workbook_entries as entries
from torquerig.report.workbook import CREATED, formats
from torquerig.report.workbook_answers import write_answers, write_ask, write_findings
from torquerig.report.workbook_kesselring import write_kesselring
from torquerig.report.workbook_links import links_of
from torquerig.report.workbook_sheets import write_elimination, write_pugh


def write_matrix_workbook(path: Path, worked: WorkedOut) -> None:
    """Write the four sheets that a person fills in, and those that follow from them.

    Criteria, Facts, Settings and Sources are entries, coloured; ``torquerig matrix FILE.xlsx`` reads them back. On the
    sheet Kesselring every number is a formula over them: a changed weight, fact or value function changes points,
    totals and ranks at once. Verdict, elimination, Pugh and open questions are as of the last run of the program.
    """
    import xlsxwriter

    book = xlsxwriter.Workbook(str(path), {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False})
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
