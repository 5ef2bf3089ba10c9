"""``torquerig reference-results``: the simulated rig compared with the results of the reference report."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.catalog.search import catalog_for
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli.common_options import catalog_option, edited, set_option
from torquerig.cli.json_option import json_option
from torquerig.cli.progress import drive_progress
from torquerig.errors import InputError
from torquerig.plain_table import grid, wrapped
from torquerig.whole_file import refuse_unwritable, whole_file

if TYPE_CHECKING:
    from torquerig.reporting.json_results.reference import ReferenceResultsResult


@click.command("reference-results")
@click.argument("scenario", type=click.Path(path_type=Path), required=False)
@click.option("--out", type=click.Path(path_type=Path), default=Path("reference_results.html"), show_default=True,
              help="Page to write.")  # fmt: skip
@click.option("--seed", type=click.IntRange(0), default=1, show_default=True, help="Seed of all random numbers.")
@click.option("--force", is_flag=True, help="Overwrite the page.")
@set_option
@catalog_option
@json_option("reference-results", reads=("scenario",))
def command(
    *, scenario: Path | None, out: Path, seed: int, force: bool, settings: tuple[str, ...], catalogs: tuple[Path, ...]
) -> ReferenceResultsResult:
    """Compare SCENARIO (default: the shipped wear rig) with Tables VIII and IX and the figures of the reference report.

    Three parameters of the load are fitted to half of the published cells; the other half is held out. Where a
    simulated value differs from the published one, the page states which change of the rig would give it.

    Example: torquerig reference-results --out reference_results.html
    """
    if out.exists() and not force:
        raise InputError(f"{out}: is there already; choose another name, or overwrite it with --force")
    if not out.resolve().parent.is_dir():
        raise InputError(f"{out}: there is no folder {out.parent}; make it first")
    refuse_unwritable(out)
    path = scenario or shipped_scenarios() / "wear_rig.yaml"
    from torquerig.reporting.json_results.reference import reference_results_result
    from torquerig.reporting.reference_report.results_page import reference_results_page
    from torquerig.study.reference_report.reasons import fit_sentences, mechanical_sentences, table_sentences
    from torquerig.study.reference_report.results import ReportResults, reference_results

    with drive_progress("reference results") as progress:
        results: ReportResults = reference_results(
            edited(path, settings), catalog_for(path, catalogs), seed=seed, progress=progress
        )
    head = ["table", "row", "published %", "", "simulated %", "samples %", "difference", "nothing fitted %"]
    rows = [
        [one.cell.table, one.cell.shown, f"{one.cell.cut:g}", "fitted" if one.cell.fitted else "held out",
         f"{one.cut:.1f}", f"{one.lowest:.1f}..{one.highest:.1f}", f"{one.difference:+.1f}", f"{one.shipped_cut:.1f}"]
        for one in results.cells
    ]  # fmt: skip
    click.echo(grid([head, *rows]) + "\n")
    notes = (*fit_sentences(results), *table_sentences(results), *mechanical_sentences(results.drop))
    for sentence in notes:
        click.echo(wrapped(sentence))
    with whole_file(out) as partial:
        partial.write_text(reference_results_page(results), encoding="utf-8", newline="\n")
    click.echo(f"wrote {out}")
    return reference_results_result(results, notes=notes, written=[out.as_posix()])
