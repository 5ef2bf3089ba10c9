"""``torquerig catalog``: motors, gearboxes, sensors and couplings with their known values."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.catalog.entry import Entry, estimates
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import Catalog
from torquerig.catalog.search import catalog_for
from torquerig.catalog.table import catalog_tables
from torquerig.cli.common_options import catalog_option
from torquerig.errors import UnknownNameError, did_you_mean
from torquerig.plain_table import grid


@click.command("catalog")
@click.argument("name", required=False)
@catalog_option
def command(name: str | None, catalogs: tuple[Path, ...]) -> None:
    """List all motors, gearboxes, sensors and couplings, or all values of NAME (an alias is accepted).

    A ? marks an unknown value. The interval after it is the range that a simulation draws from.
    """
    catalog = catalog_for(None, catalogs)
    if name is not None:
        click.echo(_details(catalog, name))
        return
    for heading, rows in catalog_tables(catalog).items():
        columns = list(rows[0]) if rows else []
        click.echo(f"{heading}\n" + grid([columns, *([str(row[key]) for key in columns] for row in rows)]) + "\n")


def _details(catalog: Catalog, name: str) -> str:
    entry = _find(catalog, name)
    rows = [["value", "known", "evidence", "source"]]
    rows += [[key, value.shown(), value.evidence, value.source] for key, value in estimates(entry) if value.source]
    words = [f"{entry.name}: {entry.title}"]
    if isinstance(entry, Motor):
        alias = catalog.resolved(name)
        words += [f"stands for {entry.stands_for} ({alias.table}): {alias.reason}"] if alias else []
        words += [f"note: {warning}" for warning in entry.warnings]
    return "\n".join([*words, grid(rows)])


def _find(catalog: Catalog, name: str) -> Entry:
    for lookup in (catalog.gearboxes, catalog.sensors, catalog.couplings):
        if name in lookup:
            return lookup[name]
    try:
        return catalog.motor(name)
    except UnknownNameError:
        known = [*catalog.motors, *catalog.gearboxes, *catalog.sensors, *catalog.couplings]
        aliases = [alias.name for motor in catalog.motors.values() for alias in motor.aliases]
        hint = did_you_mean(name, [*known, *aliases])
        raise UnknownNameError(f"there is nothing named {name!r} in the catalog; {hint}") from None
