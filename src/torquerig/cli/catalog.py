"""``torquerig catalog``: what can be bought, with its known values; conversions of data sheets, drafts and checks.

catalog [NAME]  catalog show NAME  catalog new FILE  catalog check [PATH]  catalog import FILE TARGET
catalog export NAME FILE
"""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import click

from torquerig.catalog.entry import Entry, estimates
from torquerig.catalog.motor import Motor
from torquerig.catalog.printed.converted import MARK
from torquerig.catalog.reading import Catalog
from torquerig.catalog.search import catalog_for
from torquerig.catalog.table import catalog_tables
from torquerig.cli.common_options import catalog_option
from torquerig.cli.completions import entry_names
from torquerig.cli.json_option import json_option, wants_json
from torquerig.errors import UnknownNameError, did_you_mean
from torquerig.plain_table import grid
from torquerig.reporting.json_results.catalog import (
    CatalogListResult,
    CatalogShowResult,
    catalog_list_result,
    class_result,
    entry_result,
)

_FILES = {"new": "new", "check": "check", "import": "import_", "export": "export"}
BELOW = {"show": "", **{name: f"torquerig.cli.catalog_commands.{file}" for name, file in _FILES.items()}}


class _Below(click.Group):
    """A group whose first word is a command, or the name of an entry to show."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [name for name in BELOW if self.get_command(ctx, name) is not None]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in BELOW:
            return None
        found: click.Command = import_module(BELOW[cmd_name]).command if BELOW[cmd_name] else show
        return found

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        return super().resolve_command(ctx, args if args[0] in BELOW else ["show", *args])


@click.command(
    "catalog",
    cls=_Below,
    invoke_without_command=True,
    subcommand_metavar="[NAME | show NAME | new FILE | check [PATH] | import FILE TARGET | export NAME FILE]",
)
@catalog_option
@json_option("catalog-list")
@click.pass_context
def command(context: click.Context, catalogs: tuple[Path, ...]) -> CatalogListResult | None:
    """List all motors, gearboxes, sensors, couplings and classes, or all values of NAME (an alias is accepted).

    A ? marks an unknown value. The interval after it is the range that a simulation draws from. A name that is also a
    command: torquerig catalog show NAME.

    Example: torquerig catalog bldc-12n14p
    """
    context.obj = catalogs
    if context.invoked_subcommand is not None and wants_json():
        word = context.invoked_subcommand
        raise click.UsageError(f"--json belongs after {word}: torquerig catalog {word} ... --json OUT")
    if context.invoked_subcommand is not None:
        return None
    catalog = catalog_for(None, catalogs)
    for heading, rows in catalog_tables(catalog).items():
        columns = list(rows[0]) if rows else []
        click.echo(f"{heading}\n" + grid([columns, *([str(row[key]) for key in columns] for row in rows)]) + "\n")
    return catalog_list_result(catalog)


@click.command("show")
@click.argument("name", shell_complete=entry_names)
@catalog_option
@json_option("catalog-show")
@click.pass_context
def show(context: click.Context, name: str, catalogs: tuple[Path, ...]) -> CatalogShowResult:
    """Show all values of NAME with evidence and source, and how printed figures were converted.

    Example: torquerig catalog show HDS6A-0104A
    """
    catalog = catalog_for(None, (*(context.obj or ()), *catalogs))
    click.echo(_details(catalog, name))
    if name in catalog.classes:
        return CatalogShowResult(name, class_result(catalog.classes[name]))
    entry = _find(catalog, name)
    return CatalogShowResult(entry.name, entry_result(entry, type(entry).__name__.lower()))


def _details(catalog: Catalog, name: str) -> str:
    if name in catalog.classes:
        part = catalog.classes[name]
        rows = [[key, value.shown(), value.evidence, value.source] for key, value in part.known().items()]
        return "\n".join([f"{name}: {part.title}", grid([["value", "known", "evidence", "source"], *rows])])
    entry = _find(catalog, name)
    known = [(key, value) for key, value in estimates(entry) if value.source]
    rows = [["value", "known", "evidence", "source"]]
    rows += [[key, value.shown(), value.evidence, value.source] for key, value in known]
    words = [f"{entry.name}: {entry.title}"]
    if isinstance(entry, Motor):
        alias = catalog.resolved(name)
        words += [f"stands for {entry.stands_for} ({alias.table}): {alias.reason}"] if alias else []
        words += [f"note: {warning}" for warning in entry.warnings]
    printed = [f"{key} {value.shown()} from {value.note.removeprefix(MARK)}"
               for key, value in known if value.note.startswith(MARK)]  # fmt: skip
    return "\n".join([*words, grid(rows), *(["", "converted from the data sheet:", *printed] if printed else [])])


def _find(catalog: Catalog, name: str) -> Entry:
    for lookup in (catalog.gearboxes, catalog.sensors, catalog.couplings):
        if name in lookup:
            return lookup[name]
    try:
        return catalog.motor(name)
    except UnknownNameError:
        known = [*catalog.motors, *catalog.gearboxes, *catalog.sensors, *catalog.couplings, *catalog.classes]
        aliases = [alias.name for motor in catalog.motors.values() for alias in motor.aliases]
        hint = did_you_mean(name, [*known, *aliases])
        raise UnknownNameError(f"there is nothing named {name!r} in the catalog; {hint}") from None
