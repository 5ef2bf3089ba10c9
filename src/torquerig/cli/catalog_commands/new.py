"""``torquerig catalog new``: a commented file with blanks for a new catalog entry."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.catalog.checking.draft import draft
from torquerig.catalog.part_class import KINDS
from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option
from torquerig.cli.json_option import json_option
from torquerig.errors import InputError, UnknownNameError, did_you_mean
from torquerig.reporting.json_results.simulate import WrittenResult, named
from torquerig.schema_comment import schema_comment
from torquerig.whole_file import whole_file


@click.command("new")
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--kind", "of", type=click.Choice(list(KINDS)), default="motor", show_default=True, help="What it is.")
@click.option("--like", default="", metavar="CLASS", help="The class that fills what the sheet does not state.")
@catalog_option
@json_option("catalog-new")
@click.pass_context
def command(context: click.Context, *, file: Path, of: str, like: str, catalogs: tuple[Path, ...]) -> WrittenResult:
    """Write FILE, a commented entry with blanks to fill from a data sheet; an existing file is never overwritten.

    Example: torquerig catalog new catalogs/motors/servo-400W.yaml --like servo-60mm-400W
    """
    if file.suffix not in (".yaml", ".yml"):
        raise InputError(f"{file}: a catalog file ends in .yaml; write {file.with_suffix('.yaml')}")
    if file.exists() or file.is_symlink():
        raise InputError(f"{file}: is there already; edit it, or choose another name")
    classes = catalog_for(None, (*(context.obj or ()), *catalogs)).classes
    fitting = [name for name, one in classes.items() if one.of == of]
    if like and like not in fitting:
        raise UnknownNameError(f"there is no class {like!r} of a {of}; {did_you_mean(like, fitting)}")
    file.parent.mkdir(parents=True, exist_ok=True)
    text = schema_comment(file, of) + draft(of, file.stem, classes, like=like)
    with whole_file(file) as partial:
        partial.write_text(text, encoding="utf-8")
    click.echo(f"{file}: written; fill its blanks, then: torquerig catalog check {file}")
    return WrittenResult(named([file]))
