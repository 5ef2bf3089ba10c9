"""The page of a study: one self-contained HTML file."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, Any

from torquerig.reporting.html import html
from torquerig.reporting.moving.page_scripts import data_script, page_scripts
from torquerig.reporting.study import answers, chapters, kept_pictures, tables
from torquerig.reporting.study.budget_table import TONES, budget_table, sure_sentences
from torquerig.reporting.study.rating_picture import rating_picture
from torquerig.reporting.study.sweep_chapter import matrix_model_of, sweep_chapter
from torquerig.reporting.study.trace_tables import drive_tables, functions_table
from torquerig.study.answer.kept_budget import kept_budget
from torquerig.study.load_randomness import load_randomness
from torquerig.study.trace import traced_drives

if TYPE_CHECKING:
    from torquerig.reporting.figures.page_picture import Picture
    from torquerig.study.results import DriveResult, StudyRuns
    from torquerig.study.scoring import Decided
    from torquerig.study.sweep import SweptPoint
    from torquerig.study.verdict import Verdict
    from torquerig.study.what_if import Change

RANKED = 15  # combinations in the first table; combinations.csv has all


def study_page(
    runs: StudyRuns, decided: Decided, verdict: Verdict, *, changes: Sequence[Change] = (), edits: Sequence[str] = (),
    files: Mapping[str, bytes] | None = None, swept: Sequence[SweptPoint] = (),
) -> str:  # fmt: skip
    """Return the HTML of a study's page: all figures, scripts and data inside, no request to anywhere.

    Parameters
    ----------
    files : mapping of str to bytes, optional
        Files that the page offers to save, by name; they are written into it, so that it can be mailed alone.
    swept : sequence of SweptPoint
        Computed points of a sweep; they get a chapter with sliders.
    """
    content = {
        **_answers(runs, decided, verdict, edits),
        **_first_screen(runs, decided, verdict),
        "files": tuple((name, _address(name, data)) for name, data in (files or {}).items()),
        "matrix_data": data_script("data-matrix", matrix_model_of(runs, decided)),
        "scripts": page_scripts(kept=runs.kept),
        **_found(runs, decided, verdict),
        **_readings(runs, decided, verdict),
        **_matrices(decided, verdict),
        "functions": functions_table(decided),
        "traced": drive_tables(traced_drives(decided, verdict)),
        "changes": tables.changes_table(changes) if changes else None,
        "sweep": sweep_chapter(swept),
    }
    return html("study.html", content)


def _address(name: str, data: bytes) -> str:
    kind = "text/csv" if name.endswith(".csv") else "application/octet-stream"
    return f"data:{kind};base64,{b64encode(data).decode()}"


def _first_screen(runs: StudyRuns, decided: Decided, verdict: Verdict) -> Mapping[str, Any]:
    answer = verdict.answer
    made = decided.alternatives.get(verdict.winner, decided.alternatives[decided.baseline])
    budget = kept_budget(made.drive, made.chain, runs) if verdict.winner else None
    return {
        "answer": {"sentences": answer.sentences, "figures": answer.figures,
                   "tone": TONES.get(verdict.certainty, "open")},
        "first_picture": kept_pictures.first_picture(made.drive, made.chain, runs),
        "sure": sure_sentences(verdict, budget, load_randomness(runs.drives)),
        "budget": None if budget is None else budget_table(budget),
    }  # fmt: skip


def present_drive(decided: Decided) -> DriveResult:
    """Return the drive that the others are compared with."""
    return decided.alternatives[decided.baseline].drive


def _answers(runs: StudyRuns, decided: Decided, verdict: Verdict, edits: Sequence[str]) -> Mapping[str, Any]:
    return {
        "title": str(runs.study.document.data.get("scenario", runs.study.document.path.stem)).replace("_", " "),
        "verdict": verdict,
        "question": answers.question(runs),
        "operating_point": answers.operating_point(runs, decided),
        "limits": answers.limits(runs),
        "assumptions": answers.assumptions(runs),
        "evidence": answers.evidence(),
        "command": answers.command(runs, edits),
        "edits": tuple(edits),
        "seed": runs.study.settings.seed,
        "version": runs.version,
    }


def _found(runs: StudyRuns, decided: Decided, verdict: Verdict) -> Mapping[str, Any]:
    present = present_drive(decided).candidate.name
    by_motor = groupby(runs.drives, key=lambda drive: drive.candidate.motor)
    return {
        "ranking": tables.ranking_table(decided, winner=verdict.winner, most=RANKED),
        "error_picture": kept_pictures.error_picture(runs, present=present),
        "errors": tables.error_table(runs, present=present),
        "shares": tuple(tables.shares_table(motor, tuple(drives)) for motor, drives in by_motor),
        "load_note": tables.LOAD_NOTE,
        "shares_picture": kept_pictures.shares_picture(runs),
        "out_of_reach": tables.out_of_reach_table(runs),
    }


def _readings(runs: StudyRuns, decided: Decided, verdict: Verdict) -> Mapping[str, Any]:
    present = present_drive(decided)
    winner = decided.alternatives.get(verdict.winner)
    first = winner or decided.alternatives[decided.baseline]  # its time signal is on the first screen
    listed = [(present, first.chain, "the present drive")]
    if winner is not None and winner.drive is not present:
        listed.append((winner.drive, winner.chain, "the chosen drive"))
    elif newest := tables.best_new_motor(decided):
        listed.append((newest.drive, newest.chain, "the first new motor of the ranking"))
    readings: list[Picture] = []
    for number, (drive, chain, role) in enumerate(listed, start=1):
        readings += kept_pictures.reading_pictures(
            drive, chain, runs, role=role, number=number, with_signal=drive is not first.drive
        )
    return {
        "readings": tuple(readings),
        "report_filter": kept_pictures.report_filter(present, runs),
        "effects": tables.effects_table(present),
    }


def _matrices(decided: Decided, verdict: Verdict) -> Mapping[str, Any]:
    names = tables.best_per_drive(decided)
    return {
        "elimination": chapters.elimination_table(decided.chart, decided.requirements),
        "pugh": chapters.pugh_table(decided, names),
        "kesselring": chapters.kesselring_table(decided, names),
        "rating_picture": rating_picture(decided, winner=verdict.winner),
    }
