"""``torquerig init``: a copy of the shipped catalogs and scenarios, to edit."""

from __future__ import annotations

import shutil
from pathlib import Path

import click

from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli.json_option import json_option
from torquerig.cli.schema import write_schemas
from torquerig.errors import InputError
from torquerig.plain_table import wrapped
from torquerig.reporting.json_results.simulate import WrittenResult, named
from torquerig.schema_comment import FOLDER as SCHEMAS
from torquerig.whole_file import clear_leftovers, refuse_unwritable, remove, temporary_name


@click.command("init")
@click.argument("folder", type=click.Path(path_type=Path), default=Path())
@json_option("init")
def command(folder: Path) -> WrittenResult:
    """Copy the shipped catalogs and scenarios into FOLDER (default: the current one); no file is overwritten.

    The folder schemas/ lets editors complete and check the files.

    Example: torquerig init my-rig
    """
    sources = {"catalogs": shipped_folder(), "scenarios": shipped_scenarios()}
    there = [str(folder / name) for name in (*sources, SCHEMAS) if (folder / name).exists()]
    if there:
        raise InputError(f"{there[0]}: is there already and was not changed; choose another folder or move it")
    refuse_unwritable(folder / "catalogs")
    clear_leftovers(folder)
    for name, source in sources.items():
        fresh = temporary_name(folder / name, "partial")
        try:
            shutil.copytree(source, fresh)
            fresh.rename(folder / name)
        finally:
            remove(fresh)
    write_schemas(folder / SCHEMAS)
    study = folder / "scenarios" / "wear_rig.yaml"
    click.echo(f"catalogs and scenarios are in {folder.resolve()}; now: torquerig compare {study}")
    rigs = [path.stem for path in sorted(study.parent.glob("*.yaml")) if "\nrig:" in path.read_text(encoding="utf-8")]
    click.echo(wrapped(f"rigs in scenarios/: {', '.join(rigs)}"))
    return WrittenResult(
        named([folder / name for name in (*sources, SCHEMAS)]), (f"rigs in scenarios/: {', '.join(rigs)}",)
    )
