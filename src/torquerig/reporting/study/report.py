"""The report of a study: page, CSV files and workbook, written to a folder in one step."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.reporting.replaced_folder import replaced_folder
from torquerig.reporting.study.csv_tables import combinations_csv, shares_csv
from torquerig.reporting.study.page import study_page
from torquerig.reporting.study.sweep_chapter import sweep_csv
from torquerig.reporting.workbook.study_workbook import write_workbook

if TYPE_CHECKING:
    from torquerig.study.results import StudyRuns
    from torquerig.study.scoring import Decided
    from torquerig.study.sweep import SweptPoint
    from torquerig.study.verdict import Verdict
    from torquerig.study.what_if import Change

PAGE, COMBINATIONS, SHARES, MATRICES = "index.html", "combinations.csv", "shares.csv", "matrices.xlsx"
SWEEP = "sweep.csv"


def write_study_report(
    runs: StudyRuns, decided: Decided, verdict: Verdict, folder: Path, *, changes: Sequence[Change] | None = None,
    edits: Sequence[str] = (), swept: Sequence[SweptPoint] = (),
) -> list[Path]:  # fmt: skip
    """Write the report of a study into ``folder`` and return the files, the page first.

    All files are written to a temporary folder and renamed when complete, so an error or Ctrl-C leaves the old
    report unchanged. The same study gives the same bytes.

    Parameters
    ----------
    folder : Path
        Created if it does not exist; other files in it are kept.
    changes : sequence of Change, optional
        Differences from the original study; they get a section of the page.
    edits : sequence of str
        The edits as given to ``--set``, for the command that repeats the page.
    swept : sequence of SweptPoint
        Computed points of a sweep, for a chapter of the page and a CSV file.

    Raises
    ------
    InputError
        When the folder is a file or cannot be written to.
    """
    with replaced_folder(folder) as fresh:
        texts = {COMBINATIONS: combinations_csv(runs, decided), SHARES: shares_csv(runs)}
        if swept:
            texts[SWEEP] = sweep_csv(swept)
        for name, text in texts.items():
            (fresh / name).write_text(text, encoding="utf-8", newline="\n")
        write_workbook(fresh / MATRICES, runs, decided, verdict)
        files = {name: (fresh / name).read_bytes() for name in (*texts, MATRICES)}
        page = study_page(runs, decided, verdict, changes=changes or (), edits=edits, files=files, swept=swept)
        (fresh / PAGE).write_text(page, encoding="utf-8", newline="\n")
    return [folder / name for name in (PAGE, *texts, MATRICES)]
