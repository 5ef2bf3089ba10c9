"""``torquerig catalog check``: what entries leave open, what it costs the decision, and what contradicts."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.catalog.checking.entry_check import EntryCheck, check_file, files_in
from torquerig.catalog.search import catalog_for
from torquerig.catalog.shipped import shipped_folder
from torquerig.cli.common_options import catalog_option
from torquerig.cli.json_option import json_option
from torquerig.plain_table import grid
from torquerig.reporting.json_results.catalog import CatalogCheckResult, check_result


@click.command("check")
@click.argument("path", required=False, type=click.Path(path_type=Path))
@catalog_option
@click.option("--all", "with_all", is_flag=True, help="List every open value, not only the ten dearest.")
@json_option("catalog-check", reads=("path",))
@click.pass_context
def command(
    context: click.Context, *, path: Path | None, catalogs: tuple[Path, ...], with_all: bool
) -> CatalogCheckResult:
    """Check the entries of PATH (a file or folder; else catalogs/ of this folder, else the shipped ones).

    For each entry: why it cannot be read, values that contradict, and open values with the figure that each widens most
    (the others at their middle) and the criterion or command that needs it.

    Example: torquerig catalog check catalogs/motors
    """
    here = Path("catalogs")
    chosen = path or (here if here.is_dir() else shipped_folder())
    classes = catalog_for(None, (*(context.obj or ()), *catalogs)).classes
    checks = [check_file(file, classes) for file in files_in(chosen)]
    click.echo("\n\n".join(_text(one, None if with_all else 10) for one in checks))
    result = check_result(checks)
    click.echo(f"\n{result.checked} checked, {result.faulty} with contradictions or errors")
    return result


def _text(check: EntryCheck, most: int | None) -> str:
    if check.problem:
        return check.problem
    lines = [f"{check.path}: {check.name}, {check.title}"]
    lines += [f"contradiction: {one}" for one in check.contradictions] or ["nothing contradicts"]
    if not check.costs:
        return "\n".join([*lines, "no open value moves a figure that decides"])
    rows = [[one.field, one.known, one.evidence, one.figure, one.decides] for one in check.costs[:most]]
    lines.append(grid([["open", "known", "evidence", "what it costs", "needed for"], *rows]))
    left = len(check.costs) - len(rows)
    return "\n".join([*lines, *([f"and {left} more, with --all"] if left else [])])
