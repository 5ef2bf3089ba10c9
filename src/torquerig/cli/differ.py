"""``torquerig differ``: what changed between two recordings of one rig."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import click

from torquerig.cli.common_options import catalog_option, channel_option, quantity_in
from torquerig.cli.completions import gearbox_names, motor_names
from torquerig.cli.json_option import json_option
from torquerig.cli.progress import stages
from torquerig.errors import InputError
from torquerig.metrics.changes.comparison import changes
from torquerig.plain_table import wrapped
from torquerig.recordings.files import read_recording
from torquerig.recordings.recording import Recording
from torquerig.reporting.changes_text import changes_sentences, changes_table
from torquerig.reporting.json_results.differ import DifferResult, differ_result
from torquerig.scenario.recorded.recorded_drive import RecordedDrive, recorded_drive


@click.command("differ")
@click.argument("before", type=click.Path(path_type=Path))
@click.argument("after", type=click.Path(path_type=Path))
@click.option("--scenario", type=click.Path(path_type=Path), default=None,
              help="Scenario of the rig: the lines of all its shafts, meshes, belts and bearings.")  # fmt: skip
@click.option("--motor", shell_complete=motor_names, default=None,
              help="Motor of the catalog, if the sidecars do not name it.")  # fmt: skip
@click.option("--ratio", type=float, default=None,
              help="Motor turns per output turn, if the sidecars have no gear_ratio.")  # fmt: skip
@click.option("--gearbox", shell_complete=gearbox_names, default=None,
              help="Gearbox of the catalog, for its gear mesh lines.")  # fmt: skip
@click.option("--harmonics", type=click.IntRange(1, 20), default=4, show_default=True,
              help="Number of harmonics of each family of lines.")  # fmt: skip
@click.option("--mains", callback=quantity_in("Hz"), default="50 Hz", show_default=True, help="Mains frequency.")
@click.option("--picture", type=click.Path(path_type=Path), default=None,
              help="Draw lines and bands before and after, and the changes: .svg or .png.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite an earlier picture of that name.")
@channel_option
@catalog_option
@json_option("differ", reads=("before", "after", "scenario"))
def command(
    *, before: Path, after: Path, scenario: Path | None, motor: str | None, ratio: float | None, gearbox: str | None,
    harmonics: int, mains: float, picture: Path | None, force: bool, channel: str | None, catalogs: tuple[Path, ...],
) -> DifferResult:  # fmt: skip
    """Find what changed from recording BEFORE to recording AFTER, such as before and after maintenance.

    Compared are the lines at the orders of all shafts, lines of fixed frequency, the mean, and the rms in octaves
    without the lines. Each change has a 95 % interval in N m. In a pair without a change, the probability of one or
    more false changes is 1 % for each of these four kinds. What did not change has the smallest change that would have
    been seen.

    Example: torquerig differ before.parquet after.parquet --scenario scenarios/wear_rig.yaml --picture changes.svg
    """
    if not mains > 0:
        raise InputError(f"--mains: {mains:g} Hz is not more than 0; write for example '50 Hz'")
    if picture is not None:
        from torquerig.reporting.figures.picture import check_picture

        check_picture(picture, overwrite=force)
    read = [_read(path, channel) for path in (before, after)]
    options = {"scenario": scenario, "motor": motor, "ratio": ratio, "gearbox": gearbox, "catalogs": catalogs}
    drives = [recorded_drive(one, **options) for one in read]  # type: ignore[arg-type]
    _refuse_two_rigs(read, drives)
    first, second = (replace(one, run=drive.run_of(one.run)) for one, drive in zip(read, drives, strict=True))
    with stages("differ"):
        found = changes(first, second, drives[0].kinematics, harmonics=harmonics, mains=mains)
    sentences, remarks = changes_sentences(found), [*found.remarks, *dict.fromkeys(drives[0].assumed)]
    for sentence in sentences:
        click.echo(wrapped(sentence))
    if table := changes_table(found):
        click.echo("\n" + table + "\n")
    for remark in remarks:
        click.echo(wrapped(f"note: {remark}"))
    if picture is not None:
        from torquerig.reporting.figures.changes_figure import changes_figure
        from torquerig.reporting.figures.picture import write_picture

        figure = changes_figure(found, title=f"{first.name} and {second.name}")
        write_picture(figure, picture, overwrite=force)
        click.echo(f"wrote {picture}")
    written = [] if picture is None else [picture.as_posix()]
    return differ_result(found, sentences=sentences, remarks=remarks, written=written)


def _read(path: Path, channel: str | None) -> Recording:
    read = read_recording(path)
    return read if channel is None else read.comparing(channel)


def _refuse_two_rigs(read: list[Recording], drives: list[RecordedDrive]) -> None:
    """Raise InputError where the sidecars state two motors or gear ratios."""
    one, other = read
    if None not in (one.run.motor, other.run.motor) and one.run.motor != other.run.motor:
        raise InputError(f"{one.name} is of the motor {one.run.motor}, {other.name} of {other.run.motor}; compare two "
                         "recordings of one rig")  # fmt: skip
    ratios = [drive.kinematics.ratio for drive in drives]
    if ratios[0] != ratios[1]:
        raise InputError(f"{one.name} has a gear ratio of {ratios[0]:g}, {other.name} of {ratios[1]:g}; compare two "
                         "recordings of one rig, or correct the sidecar")  # fmt: skip
