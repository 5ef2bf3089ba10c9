"""The page of a study: one self-contained HTML file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

from torquerig.reporting.figures.picture import Picture
from torquerig.reporting.html import html
from torquerig.reporting.study import answers, chapters, pictures, tables
from torquerig.reporting.study.trace_tables import drive_tables, functions_table
from torquerig.study.results import DriveResult, StudyRuns
from torquerig.study.scoring import Decided
from torquerig.study.trace import traced_drives
from torquerig.study.verdict import Verdict
from torquerig.study.what_if import Change

RANKED = 15  # combinations in the first table; combinations.csv has all


def study_page(
    runs: StudyRuns, decided: Decided, verdict: Verdict, *, changes: Sequence[Change] = (), edits: Sequence[str] = ()
) -> str:
    """Return the HTML of a study's page: with inline figures, without scripts or external requests."""
    content = {
        **_answers(runs, decided, verdict, edits),
        **_found(runs, decided, verdict),
        **_readings(runs, decided, verdict),
        **_matrices(decided, verdict),
        "functions": functions_table(decided),
        "traced": drive_tables(traced_drives(decided, verdict)),
        "changes": tables.changes_table(changes) if changes else None,
    }
    return html("study.html", content)


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
        "error_picture": pictures.error_picture(runs, present=present),
        "errors": tables.error_table(runs, present=present),
        "shares": tuple(tables.shares_table(motor, tuple(drives)) for motor, drives in by_motor),
        "load_note": tables.LOAD_NOTE,
        "shares_picture": pictures.shares_picture(runs),
        "out_of_reach": tables.out_of_reach_table(runs),
    }


def _readings(runs: StudyRuns, decided: Decided, verdict: Verdict) -> Mapping[str, Any]:
    present = present_drive(decided)
    winner = decided.alternatives.get(verdict.winner)
    listed = [(present, (winner or decided.alternatives[decided.baseline]).chain, "the present drive")]
    if winner is not None and winner.drive is not present:
        listed.append((winner.drive, winner.chain, "the chosen drive"))
    elif newest := tables.best_new_motor(decided):
        listed.append((newest.drive, newest.chain, "the first new motor of the ranking"))
    readings: list[Picture] = []
    for drive, chain, role in listed:
        shown = pictures.filtered(drive, chain, runs)
        readings += pictures.reading_pictures(shown, role=role) if shown else ()
    return {
        "readings": tuple(readings),
        "report_filter": pictures.report_filter(present, runs),
        "effects": tables.effects_table(present),
    }


def _matrices(decided: Decided, verdict: Verdict) -> Mapping[str, Any]:
    names = tables.best_per_drive(decided)
    return {
        "elimination": chapters.elimination_table(decided.chart, decided.requirements),
        "pugh": chapters.pugh_table(decided, names),
        "kesselring": chapters.kesselring_table(decided, names),
        "rating_picture": pictures.rating_picture(decided, winner=verdict.winner),
    }
