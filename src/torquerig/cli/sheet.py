"""``torquerig sheet``: a draft of the sidecar of a recording."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.cli.json_option import json_option
from torquerig.cli.recordings_named import recordings_in
from torquerig.errors import InputError
from torquerig.recordings.files.sidecar_choice import sidecar_target
from torquerig.recordings.inspection.draft_sidecar import draft_sidecar
from torquerig.recordings.inspection.file_contents import file_contents
from torquerig.reporting.json_results.simulate import WrittenResult, named
from torquerig.schema_comment import schema_comment
from torquerig.whole_file import whole_file


@click.command("sheet")
@click.argument("recordings", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--print", "as_text", is_flag=True, help="Print the drafts instead of writing them.")
@click.option("--force", is_flag=True, help="Overwrite existing sidecars.")
@json_option("sheet", reads=("recordings",))
def command(*, recordings: tuple[Path, ...], as_text: bool, force: bool) -> WrittenResult:
    """Draft the sidecar of each of RECORDINGS: a YAML file of the same name to correct and complete.

    What the file states is written; what it does not state is a commented line with EDIT. No scale is guessed.

    Example: torquerig sheet run1.tdms
    """
    paths = [path for one in recordings for path in recordings_in(one)]
    targets = {path: sidecar_target(path) for path in paths}
    for target in targets.values():
        if target.exists() and not (force or as_text):
            raise InputError(f"{target}: is there already; edit it, or overwrite it with --force")
    texts, notes = {}, []
    for path, target in targets.items():
        text = draft_sidecar(file_contents(path))
        if as_text:
            click.echo(text, nl=False)
            texts[path.name] = text
            continue
        with whole_file(target) as partial:
            partial.write_text(schema_comment(target, "sidecar") + text, encoding="utf-8")
        edits = text.count("# EDIT")
        click.echo(f"wrote {target}" + (f"; complete its {edits} lines with EDIT" if edits else ""))
        notes += [f"{target.name}: {edits} lines with EDIT to complete"] if edits else []
    return WrittenResult(() if as_text else named(list(targets.values())), tuple(notes), texts=texts)
