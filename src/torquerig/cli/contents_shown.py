"""The contents of a file on the terminal: columns, what they are taken for, and what is missing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import click

from torquerig.plain_table import grid, wrapped
from torquerig.recordings.inspection.file_contents import ColumnContents, FileContents


def show_contents(contents: FileContents) -> None:
    """Print the columns of a file that cannot be used as it is, and the reason with its remedy."""
    click.echo(f"{contents.path}: {len(contents.columns)} columns of numbers")
    figures = ["minimum", "mean", "maximum", "std"]
    rows = [["column", "quantity", "unit", "rate", "samples", "length", *figures, "known by"]]
    rows += [_row(one) for one in contents.columns]
    click.echo(grid(rows))
    show_reading(contents.notes, contents.skipped, {one.name: (one.reason, one.missing) for one in contents.columns})
    for one in contents.columns:
        if one.gone:
            click.echo(f"suspicious: {one.name} has {one.gone} samples that are no finite number")
    if contents.problem:
        click.echo(wrapped(f"cannot be used yet: {contents.problem}"))


def show_reading(notes: Sequence[str], skipped: Mapping[str, str], missing: Mapping[str, tuple[str, str]]) -> None:
    """Print what the reader understood, the columns that it left out, and why a sidecar must add what, by column."""
    for note in notes:
        click.echo(wrapped(f"read: {note}"))
    for name, reason in skipped.items():
        click.echo(wrapped(f"skipped: {name}: {reason}"))
    needed = {name: one for name, one in missing.items() if one[1]}
    for name, (reason, what) in needed.items():
        click.echo(wrapped(f"not known: {name}: {reason}; to be added: {what}"))
    if needed:
        click.echo("torquerig sheet drafts a sidecar in which to add it")


def _row(one: ColumnContents) -> list[str]:
    rate = "?" if one.rate is None else f"{one.rate:g} Hz"
    length = "?" if one.duration is None else f"{one.duration:g} s"
    figures = (f"{number:.6g}" for number in (one.minimum, one.mean, one.maximum, one.std))
    return [
        one.name,
        one.quantity,
        one.unit or "?",
        rate,
        str(one.samples),
        length,
        *figures,
        known_by(one.reason, one.missing),
    ]


def known_by(reason: str, missing: str) -> str:
    """Return how quantity and unit of a column are known, for a table; a line below says what is not."""
    return "not known" if missing else reason or "the sidecar"
