"""``torquerig compare``: rank every motor, gearbox and filter of a study."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import click

from torquerig.cases.kept_results import KeptResults
from torquerig.catalog.search import unread_catalog_for
from torquerig.cli.common_options import cache_options, catalog_option, kept_results, note_from_cache, set_option
from torquerig.cli.json_option import json_option
from torquerig.cli.matrix import ENDINGS, check_target
from torquerig.cli.progress import drive_progress
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.plain_table import grid, wrapped
from torquerig.reporting.json_results.compare import (
    ComparePointsResult,
    CompareResult,
    PointResult,
    compare_result,
    not_ranked,
)
from torquerig.reporting.json_results.figures import figure_result
from torquerig.reporting.json_results.simulate import named
from torquerig.reporting.json_results.values import Missing
from torquerig.reporting.pdf import check_pdf_printer, write_pdf
from torquerig.reporting.study.report import write_study_report
from torquerig.reporting.study.text import ranked_text, shares_text, sweep_text
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import Study, open_study
from torquerig.study.left_out import left_out_gearboxes
from torquerig.study.operating_points import Point, points_of
from torquerig.study.results import StudyRuns
from torquerig.study.run_study import drives_of, run_study
from torquerig.study.scoring import Decided, decide
from torquerig.study.study_facts import study_facts
from torquerig.study.sweep import SweptPoint, sweep, sweep_axes
from torquerig.study.trace import check_traced, traced_cell
from torquerig.study.verdict import Verdict, verdict
from torquerig.study.what_if import Change, changes
from torquerig.whole_file import refuse_unwritable


@click.command("compare")
@click.argument("scenario", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), default=None,
              help="Folder of the report; default reports/NAME-OF-SCENARIO.")  # fmt: skip
@click.option("--all-points", is_flag=True, help="Write one report for each occupancy and particle size of the study.")
@click.option("--sweep", "sweeps", multiple=True, metavar="PATH=V1,V2,...",
              help="Also compute the study at these values; they become a slider of the page; repeatable.")  # fmt: skip
@click.option(
    "--trace", "traced", nargs=2, multiple=True, metavar="DRIVE CRITERION",
    help="Also show how this cell was computed: a criterion of 'DRIVE | FILTER', or a requirement on DRIVE; "
         "repeatable.",
)  # fmt: skip
@click.option(
    "--matrix", "matrices", multiple=True, type=click.Path(path_type=Path), metavar="FILE",
    help=f"Also write a decision matrix of the drives, each with its best filter: {', '.join(ENDINGS)}.",
)  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite the files of --matrix.")
@click.option("--pdf", is_flag=True, help="Also print the page as index.pdf, with Chromium or WeasyPrint.")
@click.option("--workers", type=click.IntRange(1), default=None, help="Number of parallel runs. Default: one per core.")
@cache_options
@set_option
@catalog_option
@json_option("compare", reads=("scenario",))
def command(
    *, scenario: Path, out: Path | None, all_points: bool, sweeps: tuple[str, ...], workers: int | None,
    settings: tuple[str, ...], catalogs: tuple[Path, ...], traced: tuple[tuple[str, str], ...],
    matrices: tuple[Path, ...], force: bool, pdf: bool, cache: Path | None, no_cache: bool,
) -> CompareResult | ComparePointsResult:  # fmt: skip
    """Simulate every motor x gearbox x filter of SCENARIO, rank them, and write a report.

    With --set both the original and the edited study run, and the report lists the differences. Each drive is kept as
    soon as it is measured: a run that was stopped goes on, and after a change only the drives that it concerns are
    simulated; none after a change of weights, limits or points.

    Example: torquerig compare scenarios/wear_rig.yaml --set load.occupancy=11
    """
    document = read_document(scenario)
    study = open_study(overridden(document, settings), unread_catalog_for(scenario, catalogs))
    folder = out or Path("reports") / scenario.stem
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder} is a file; name a folder for the report with --out")
    refuse_unwritable(folder)
    for path in matrices:
        check_target(path, force=force)
    if pdf:
        check_pdf_printer()
    axes = sweep_axes(study.document, sweeps)
    if all_points and (traced or matrices or pdf or sweeps):
        raise InputError("--trace, --matrix, --sweep and --pdf need one study; remove --all-points")
    with kept_results(cache, no_cache=no_cache) as kept:
        if traced:
            check_traced(study, traced, drives_of(study, kept))
        run = partial(_run, workers=workers, kept=kept)
        if all_points:
            return _compare_points(study, folder, run)
        swept = sweep(study.document, study.catalog, axes, run=run)
        runs = run(study, "edited study" if settings else "study")
        found: tuple[Change, ...] = ()
        if settings:
            original = run(open_study(document, study.catalog), "original study")
            found = changes(original, runs)
        decided, answer = _print_ranking(runs, swept)
        _print_changes(found, settings, unit=study.effort_unit)
        _print_traces(traced, decided, answer)
        _write_matrices(matrices, decided, name=scenario.stem, seed=study.settings.seed)
        written = write_study_report(runs, decided, answer, folder, changes=found or None, edits=settings, swept=swept)
    if pdf:
        written.append(written[0].with_suffix(".pdf"))
        write_pdf(written[0], written[-1])
    elif (earlier := written[0].with_suffix(".pdf")).exists():
        click.echo(f"{earlier} is of an earlier run; --pdf prints this one")
    click.echo(f"\nreport: {written[0]}\n")
    click.echo("\n".join(wrapped(sentence) for sentence in answer.answer.sentences))
    return compare_result(
        runs, decided, answer, changes=found, notes=_notes(runs), written=named([*matrices, *written]), swept=swept
    )


def _print_traces(traced: tuple[tuple[str, str], ...], decided: Decided, answer: Verdict) -> None:
    if not traced:
        return
    from torquerig.decide.matrix_io.certainty_text import trace_text

    for pair in traced:
        click.echo("\n" + trace_text(traced_cell(decided, answer, *pair)))


def _write_matrices(matrices: tuple[Path, ...], decided: Decided, *, name: str, seed: int) -> None:
    if not matrices:
        return
    from torquerig.decide.matrix_analysis import analyse_matrix
    from torquerig.reporting.matrix.files import write_matrix
    from torquerig.study.as_matrix import as_matrix

    for path in matrices:
        write_matrix(analyse_matrix(as_matrix(decided, name=name, seed=seed)), path)
        click.echo(f"wrote {path}", err=True)


def _run(study: Study, title: str, *, workers: int | None, kept: KeptResults | None) -> StudyRuns:
    measured = 0

    def noted(done: int, total: int, name: str) -> None:
        nonlocal measured
        measured = done
        progress(done, total, name)

    try:
        with drive_progress(title) as progress:
            runs = run_study(study, progress=noted, workers=workers, kept=kept)
    except KeyboardInterrupt as stop:
        if kept is None:
            raise
        raise KeyboardInterrupt(
            f"interrupted; {measured} drives of the {title} are kept in {kept.folder}, and the same command goes on "
            "from there"
        ) from stop
    if kept is not None:
        note_from_cache(runs.from_store)
        click.echo(f"{title}: {runs.from_store} of {len(runs.drives)} drives from the cache {kept.folder}", err=True)
    return runs


def _print_ranking(runs: StudyRuns, swept: tuple[SweptPoint, ...]) -> tuple[Decided, Verdict]:
    decided = decide(runs)
    answer = verdict(decided)
    click.echo(ranked_text(decided) + "\n")
    click.echo(shares_text(runs))
    if out := not_ranked(runs, decided):
        click.echo("\nEliminated or open, and why:")
        for one in out:
            click.echo(wrapped(f"{one.drive} ({one.decision}): {'; '.join(one.reasons)}"))
    for note in _notes(runs):
        click.echo("\n" + wrapped(note))
    if swept:
        click.echo("\n" + sweep_text(swept))
    return decided, answer


def _notes(runs: StudyRuns) -> list[str]:
    return [note for note in (left_out_gearboxes(runs.study), study_facts(runs).held) if note]


def _print_changes(found: tuple[Change, ...], settings: tuple[str, ...], *, unit: str) -> None:
    if not found:
        return
    rows = [["original", "edited", f"error {unit}", "edited", "change %", f"disturbance {unit}", "edited"]]
    for change in found:
        before, after = change.error_before, change.error_after
        change_percent = "-" if before is None or after is None or before == 0 else f"{100 * (after / before - 1):+.1f}"
        rows.append([change.before, change.after, _number(before), _number(after), change_percent,
                     _number(change.disturbance_before), _number(change.disturbance_after)])  # fmt: skip
    click.echo(f"\nEffect of {' and '.join(settings)} (reading error with the best filter of each drive):")
    click.echo(grid(rows))


def _compare_points(study: Study, folder: Path, run: Callable[[Study, str], StudyRuns]) -> ComparePointsResult:
    points: tuple[Point, ...] = points_of(study)
    if not points:
        raise InputError(
            f"{study.document.place(('study',))}: all_points is missing; list occupancy or particle_size there"
        )
    rows = [["occupancy %", "particle mm", "winner", f"error {study.effort_unit}", "verdict"]]
    quick = replace(study, settings=study.settings.model_copy(update={"draws": 0}))
    made_points = []
    for number, point in enumerate(points, start=1):
        runs = run(point.applied(quick), f"point {number} of {len(points)}")
        decided = decide(runs)
        answer = verdict(decided)
        written = write_study_report(runs, decided, answer, folder / point.name)
        made = decided.alternatives.get(answer.winner)
        error = made.drive.chains[made.chain].truth_error if made else None
        rows.append([f"{point.occupancy_percent:g}", f"{1e3 * point.particle_size:g}", answer.winner or "-",
                     _number(error.value if error else None), answer.certainty])  # fmt: skip
        shown = figure_result(error) if error else Missing("no drive meets the requirements")
        made_points.append(PointResult(point.occupancy_percent, 1e3 * point.particle_size, answer.winner,
                                       str(answer.certainty), shown, named(written[:1])[0]))  # fmt: skip
    click.echo(grid(rows) + f"\n\none report per point in {folder}; each point has one Monte Carlo sample per "
                            f"drive, so its "
               "uncertainty covers the intervals of the catalog only")  # fmt: skip
    title = str(study.document.data.get("title", study.document.path.stem))
    return ComparePointsResult(title, study.settings.seed, tuple(made_points))


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.4f}"
