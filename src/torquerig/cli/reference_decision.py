"""``torquerig reference-decision``: a published motor decision computed again, cell by cell."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option
from torquerig.cli.json_option import json_option
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.whole_file import refuse_unwritable

if TYPE_CHECKING:
    from torquerig.reporting.json_results.reference import ReferenceDecisionResult
    from torquerig.study.reference_decision.decision import ReferenceDecision

ENDINGS = (".html", ".md")


@click.command("reference-decision")
@click.argument("plan", type=click.Path(path_type=Path), required=False)
@click.option("--out", "outs", multiple=True, type=click.Path(path_type=Path), metavar="FILE",
              help="Write the page as .html or .md; repeatable.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite the files of --out.")
@click.option(
    "--draws",
    type=click.IntRange(0),
    default=None,
    help="Further Monte Carlo samples of each drive. Default: as in PLAN.",
)
@click.option("--workers", type=click.IntRange(1), default=None, help="Number of parallel runs. Default: one per core.")
@catalog_option
@json_option("reference-decision", reads=("plan",))
def command(
    *, plan: Path | None, outs: Sequence[Path], force: bool, draws: int | None, workers: int | None,
    catalogs: tuple[Path, ...],
) -> ReferenceDecisionResult:  # fmt: skip
    """Compute the published tables of PLAN from catalog and simulation, and the motor to buy or keep.

    PLAN states how each published criterion is computed. Default: the shipped scenarios/reference_decision.yaml.

    Example: torquerig reference-decision --out decision.html
    """
    from torquerig.catalog.shipped import shipped_scenarios
    from torquerig.cli.progress import drive_progress
    from torquerig.reporting.json_results.reference import reference_decision_result
    from torquerig.study.reference_decision.decision import reference_decision
    from torquerig.study.reference_decision.plan import read_plan

    for path in outs:
        _check_target(path, force=force)
    path = plan or shipped_scenarios() / "reference_decision.yaml"
    made = read_plan(read_document(path), catalog_for(path, catalogs), draws=draws)
    with drive_progress("study") as progress:
        decision = reference_decision(made, progress=progress, workers=workers)
    _print_decision(decision)
    for target in outs:
        from torquerig.reporting.reference_report.decision_page import write_decision

        write_decision(decision, target)
        click.echo(f"wrote {target}", err=True)
    return reference_decision_result(decision, written=[one.as_posix() for one in outs])


def _print_decision(decision: ReferenceDecision) -> None:
    from torquerig.plain_table import grid, wrapped
    from torquerig.study.reference_decision.reasons import Cause

    rows = [["table", "cells", *(str(cause) for cause in Cause)]]
    for one in decision.tables:
        counts = [sum(cell.reason.cause is cause for cell in one.cells) for cause in Cause]
        rows.append([one.table.sheet.name, str(len(one.cells)), *map(str, counts)])
    click.echo(grid(rows) + "\n")
    for sentence in decision.answer.sentences():
        click.echo(wrapped(sentence))
    for fact in decision.answer.missing:
        click.echo(wrapped(f"most useful missing fact: {fact}"))


def _check_target(path: Path, *, force: bool) -> None:
    if path.suffix.lower() not in ENDINGS:
        raise InputError(f"{path}: the decision is written as {' or '.join(ENDINGS)}; choose one of these endings")
    if path.exists() and not force:
        raise InputError(f"{path}: is there already; choose another name, or overwrite it with --force")
    if not path.parent.is_dir():
        raise InputError(f"{path}: there is no folder {path.parent}; make it first")
    refuse_unwritable(path)
