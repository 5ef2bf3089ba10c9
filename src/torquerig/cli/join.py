"""``torquerig join``: columns of several rates or files as one recording."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.cli.common_options import quantity_in
from torquerig.cli.json_option import json_option
from torquerig.errors import InputError, UnitError
from torquerig.plain_table import wrapped
from torquerig.recordings.files import check_target, write_recording
from torquerig.recordings.joining.join import join_recordings, split_recording
from torquerig.recordings.joining.tracks import LONGEST_GAP
from torquerig.reporting.json_results.simulate import WrittenResult, named
from torquerig.units import parse_quantity


@click.command("join")
@click.argument("recordings", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--out", required=True, type=click.Path(path_type=Path),
              help="Recording to write: .parquet, .csv, .mat or .tdms, with its sidecar.")  # fmt: skip
@click.option("--rate", default=None, metavar="FREQUENCY",
              help="Common sample rate, such as '1 kHz'; the highest of the columns if not given.")  # fmt: skip
@click.option("--align", default="start", show_default=True, metavar="start|clock|CHANNEL",
              help="Begin all files at once, by their columns of times, or by a channel that all have.")  # fmt: skip
@click.option("--bridge", default=None, callback=quantity_in("s"), metavar="TIME",
              help="Longest pause to fill with straight lines, where nothing moves in it. Default: 1 s.")  # fmt: skip
@click.option("--split", is_flag=True,
              help="Write each stretch between longer pauses as a recording: OUT-001, OUT-002, ...")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite an earlier recording of that name.")
@json_option("join", reads=("recordings",))
def command(
    *, recordings: tuple[Path, ...], out: Path, rate: str | None, align: str, bridge: float | None, split: bool,
    force: bool,
) -> WrittenResult:  # fmt: skip
    """Bring the columns of RECORDINGS to one sample rate and write them as one recording.

    For one file whose columns have several rates or uneven times, and for several files of one run. Each thing that is
    done is printed and kept in the sidecar. A map that was recorded at standstill, place by place, becomes one
    recording with --bridge; a log of several runs becomes one recording per run with --split.

    Example: torquerig join torque.tdms speed.csv --align clock --out run1.parquet
    """
    try:
        common = None if rate is None else parse_quantity(rate, "Hz")
    except UnitError as error:
        raise UnitError(f"--rate: {error}") from None
    if common is not None and common <= 0:
        raise InputError(f"--rate: {rate!r} is no rate; write one above 0, such as '1 kHz'")
    if bridge is not None and not bridge > 0:
        raise InputError(f"--bridge: {bridge:g} s fills no pause; write for example '2 s'")
    longest_gap = LONGEST_GAP if bridge is None else bridge
    if split:
        return _write_stretches(recordings, out, rate=common, longest_gap=longest_gap, force=force)
    check_target(out, overwrite=force, inputs=recordings)
    joined = join_recordings(recordings, rate=common, align=align, longest_gap=longest_gap)
    for note in joined.notes:
        click.echo(wrapped(note))
    written = write_recording(joined.recording, out, overwrite=force)
    for path in written:
        click.echo(f"wrote {path}")
    return WrittenResult(named(written), tuple(joined.notes))


def _write_stretches(
    recordings: tuple[Path, ...], out: Path, *, rate: float | None, longest_gap: float, force: bool
) -> WrittenResult:
    """Write the stretches of one file between its pauses; nothing is written where one target cannot be."""
    if len(recordings) > 1:
        raise InputError(f"--split cuts one recording, and {len(recordings)} are named; name one")
    parts = split_recording(recordings[0], rate=rate, longest_gap=longest_gap)
    digits = max(3, len(str(len(parts))))
    targets = [out.with_name(f"{out.stem}-{number:0{digits}d}{out.suffix}") for number in range(1, len(parts) + 1)]
    for target in targets:
        check_target(target, overwrite=force, inputs=recordings)
    notes, written = tuple(dict.fromkeys(note for part in parts for note in part.notes)), []
    for note in notes:
        click.echo(wrapped(note))
    for part, target in zip(parts, targets, strict=True):
        written += write_recording(part.recording, target, overwrite=force)
    click.echo(f"wrote {len(parts)} recordings: {targets[0]} to {targets[-1].name}, each with its sidecar")
    return WrittenResult(named(written), notes)
