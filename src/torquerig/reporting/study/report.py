"""The whole report of a study: page, CSV files and workbook, swapped into their folder in one step."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from torquerig.reporting.replaced_folder import replaced_folder
from torquerig.reporting.study.csv_tables import combinations_csv, shares_csv
from torquerig.reporting.study.page import study_page
from torquerig.reporting.workbook.study_workbook import write_workbook
from torquerig.study.results import StudyRuns
from torquerig.study.scoring import Decided
from torquerig.study.verdict import Verdict
from torquerig.study.what_if import Change

PAGE, COMBINATIONS, SHARES, MATRICES = "index.html", "combinations.csv", "shares.csv", "matrices.xlsx"


def write_study_report(
    runs: StudyRuns, decided: Decided, verdict: Verdict, folder: Path, *, changes: Sequence[Change] | None = None,
    edits: Sequence[str] = (),
) -> list[Path]:  # fmt: skip
    """Write the report of a study into ``folder`` and return the files, the page first.

    Everything is written beside the folder first and renamed in when complete, so that an error or Ctrl-C leaves the
    old report as it was. The same study gives the same bytes.

    Parameters
    ----------
    folder : Path
        Made where it does not exist; files in it that are no part of the report are kept.
    changes : sequence of Change, optional
        What an edit changed against the original study; gives the page a section.
    edits : sequence of str
        The edits as given to ``--set``, for the command that makes the page again.

    Raises
    ------
    InputError
        When the folder is a file or cannot be written to.
    """
    with replaced_folder(folder) as fresh:
        texts = {
            PAGE: study_page(runs, decided, verdict, changes=changes or (), edits=edits),
            COMBINATIONS: combinations_csv(runs, decided),
            SHARES: shares_csv(runs),
        }
        for name, text in texts.items():
            (fresh / name).write_text(text, encoding="utf-8", newline="\n")
        write_workbook(fresh / MATRICES, runs, decided, verdict)
    return [folder / name for name in (PAGE, COMBINATIONS, SHARES, MATRICES)]
