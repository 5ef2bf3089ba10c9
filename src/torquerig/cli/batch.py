"""``torquerig batch``: one command over all recordings of a folder, one row per file in a table."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.cli.batch_files import COMMANDS, file_outcomes, files_of
from torquerig.cli.json_option import Partly, json_option
from torquerig.errors import InputError, TorquerigError
from torquerig.plain_table import wrapped
from torquerig.reporting.json_results.batch import BatchResult, FileOutcome, batch_result
from torquerig.whole_file import refuse_unwritable, whole_file

_FIRST = ("file", "status", "reason")  # columns by which an earlier table of this command is known
ENDINGS = (".csv", ".parquet")


@click.command("batch", context_settings={"ignore_unknown_options": False})
@click.argument("name", metavar="COMMAND", type=click.Choice(list(COMMANDS)))
@click.argument("folder", type=click.Path(path_type=Path))
@click.argument("options", nargs=-1, type=click.UNPROCESSED)
@click.option("--table", type=click.Path(path_type=Path), default=None, metavar="FILE",
              help="Table to write, .csv or .parquet. Default: FOLDER-COMMAND.csv here.")  # fmt: skip
@click.option("--workers", type=click.IntRange(1), default=1, show_default=True, help="Files at a time.")
@json_option("batch", reads=("folder",))
def command(
    *, name: str, folder: Path, options: tuple[str, ...], table: Path | None, workers: int
) -> BatchResult | Partly:
    """Run COMMAND (filter, ordermap or info) on each recording of FOLDER; its options follow after --.

    The table has one row per file; a file that fails is a row with the reason. The JSON of each file is written next to
    it as NAME.COMMAND.json, and with filter and one --chain the filtered recording as NAME.CHAIN.parquet. A call that
    was stopped goes on where it was: results of the same file, options and version are taken over. Nothing else is
    overwritten.

    Example: torquerig batch filter measurements --table filtered.csv -- --chain order_lines_low_pass
    """
    target = table or Path(f"{folder.resolve().name}-{name}.csv")
    if not folder.is_dir():
        raise InputError(f"{folder}: there is no such folder; check the path")
    _check_table(target)
    files = files_of(folder, name, options, without=target)
    outcomes = file_outcomes(name, files, options, workers=workers, title=f"{name} of {folder}")
    rows = batch_result(name, folder, outcomes, table=target)
    _write(target, outcomes)
    failed = [one for one in outcomes if one.status == "failed"]
    again = sum(one.status == "taken over" for one in outcomes)
    click.echo(
        f"{len(outcomes)} files: {len(outcomes) - len(failed) - again} computed, {again} taken over, "
        f"{len(failed)} failed"
    )
    for one in failed:
        click.echo(wrapped(f"failed: {one.file.name}: {one.reason}"))
    click.echo(f"wrote {target}")
    if failed:
        return Partly(rows, TorquerigError(f"{len(failed)} of {len(outcomes)} files failed; {target} says why"))
    return rows


def _check_table(target: Path) -> None:
    """Refuse a table that cannot be written, or that would replace another file than an earlier table."""
    if target.suffix.lower() not in ENDINGS:
        raise InputError(f"{target}: a table ends in {' or '.join(ENDINGS)}; choose one of them")
    if not target.parent.is_dir():
        raise InputError(f"{target}: there is no folder {target.parent}; make it first")
    if target.exists() and _columns_of(target)[:3] != _FIRST:
        raise InputError(
            f"{target}: is there already and no table of torquerig batch; choose another name with --table"
        )
    refuse_unwritable(target)


def _columns_of(target: Path) -> tuple[str, ...]:
    """Return the columns of a table that is there; none where it is no table."""
    if target.suffix.lower() == ".csv":
        with target.open("rb") as file:
            return tuple(file.read(4096).decode("utf-8", "replace").split("\n")[0].strip().split(","))
    import pyarrow as pa
    from pyarrow import parquet

    try:
        return tuple(parquet.read_schema(target).names)
    except (pa.ArrowException, OSError):
        return ()


def _write(target: Path, outcomes: list[FileOutcome]) -> None:
    import pandas as pd

    from torquerig.harmless import csv_cell

    rows = [
        {"file": one.file.name, "status": one.status, "reason": one.reason, "json": one.json, **one.figures}
        for one in outcomes
    ]
    frame = pd.DataFrame(rows, columns=list(dict.fromkeys(key for row in rows for key in row)))
    with whole_file(target) as partial:
        if target.suffix.lower() == ".csv":
            words = frame.select_dtypes(include=["object", "string"]).columns
            frame[words] = frame[words].map(lambda one: csv_cell(one) if isinstance(one, str) else one)
            frame.to_csv(partial, index=False, lineterminator="\n")
        else:
            frame.to_parquet(partial, index=False)
