"""``torquerig join``: columns of several rates or files as one recording."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.errors import InputError, UnitError
from torquerig.plain_table import wrapped
from torquerig.recordings.files import check_target, write_recording
from torquerig.recordings.joining.join import join_recordings
from torquerig.units import parse_quantity


@click.command("join")
@click.argument("recordings", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--out", required=True, type=click.Path(path_type=Path),
              help="Recording to write: .parquet, .csv, .mat or .tdms, with its sidecar.")  # fmt: skip
@click.option("--rate", default=None, metavar="FREQUENCY",
              help="Common sample rate, such as '1 kHz'; the highest of the columns if not given.")  # fmt: skip
@click.option("--align", default="start", show_default=True, metavar="start|clock|CHANNEL",
              help="Begin all files at once, by their columns of times, or by a channel that all have.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite an earlier recording of that name.")
def command(*, recordings: tuple[Path, ...], out: Path, rate: str | None, align: str, force: bool) -> None:
    """Bring the columns of RECORDINGS to one sample rate and write them as one recording.

    For one file whose columns have several rates or uneven times, and for several files of one run. Each thing that is
    done is printed and kept in the sidecar.

    Example: torquerig join torque.tdms speed.csv --align clock --out run1.parquet
    """
    try:
        common = None if rate is None else parse_quantity(rate, "Hz")
    except UnitError as error:
        raise UnitError(f"--rate: {error}") from None
    if common is not None and common <= 0:
        raise InputError(f"--rate: {rate!r} is no rate; write one above 0, such as '1 kHz'")
    check_target(out, overwrite=force, inputs=recordings)
    joined = join_recordings(recordings, rate=common, align=align)
    for note in joined.notes:
        click.echo(wrapped(note))
    for path in write_recording(joined.recording, out, overwrite=force):
        click.echo(f"wrote {path}")
