"""``torquerig schema``: JSON Schemas of the files that torquerig reads and writes."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.cli.completions import schema_names
from torquerig.errors import InputError
from torquerig.plain_table import wrapped
from torquerig.whole_file import whole_file


@click.command("schema")
@click.argument("name", required=False, shell_complete=schema_names)
@click.option("--all", "folder", type=click.Path(path_type=Path), default=None, metavar="FOLDER",
              help="Write every schema into FOLDER as NAME.json; earlier schemas there are replaced.")  # fmt: skip
def command(*, name: str | None, folder: Path | None) -> None:
    """Print the JSON Schema NAME; without NAME list the names.

    An editor completes and checks a YAML file that has the line `# yaml-language-server: $schema=PATH`. The files of
    torquerig init have it. Names that end with -json are the schemas of what --json writes.

    Example: torquerig schema motor
    """
    from torquerig.reporting.file_schemas.named import FILES, OUTPUTS, schema_named
    from torquerig.reporting.json_results.document import json_text

    if folder is not None:
        if name is not None:
            raise InputError("--all writes every schema; remove NAME, or --all")
        click.echo(f"wrote {write_schemas(folder)} schemas into {folder}")
    elif name is None:
        click.echo(wrapped(f"files: {', '.join(FILES)}"))
        click.echo(wrapped(f"output of --json: {', '.join(OUTPUTS)}"))
    else:
        click.echo(json_text(schema_named(name)), nl=False)


def write_schemas(folder: Path) -> int:
    """Write every schema into a folder and return their number."""
    from torquerig.reporting.file_schemas.named import FILES, OUTPUTS, schema_named
    from torquerig.reporting.json_results.document import json_text

    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder}: is a file; name a folder")
    folder.mkdir(parents=True, exist_ok=True)
    for name in (*FILES, *OUTPUTS):
        with whole_file(folder / f"{name}.json") as partial:
            partial.write_text(json_text(schema_named(name)), encoding="utf-8", newline="\n")
    return len(FILES) + len(OUTPUTS)
