"""``torquerig matrix``: elimination, Pugh and Kesselring from a file."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.decide.matrix_report import matrix_report
from torquerig.document import read_document
from torquerig.errors import InputError


@click.command("matrix")
@click.argument("file", type=click.Path(path_type=Path))
def command(file: Path) -> None:
    """Recompute the matrices of FILE and list what is wrong with them.

    FILE holds published tables (scenarios/seed_tables.yaml) or a matrix of one's own (scenarios/matrix_example.yaml).
    """
    data = read_document(file).data
    if isinstance(data, dict) and "rig" in data:
        raise InputError(f"{file}: is the scenario of a rig, not a matrix; torquerig compare works its matrices out")
    click.echo(matrix_report(file), nl=False)
