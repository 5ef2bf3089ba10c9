"""``torquerig info``: channels, levels and faults of a recording."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import suppress
from dataclasses import replace
from math import ceil, floor, isfinite, log10, pi
from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.catalog.search import catalog_for
from torquerig.catalog.winding import winding_of
from torquerig.cli.contents_shown import known_by, show_contents, show_reading
from torquerig.cli.json_option import Partly, json_option, wants_json
from torquerig.cli.recordings_named import recordings_in
from torquerig.cli.suspicions import print_suspicions
from torquerig.errors import InputError, RecordingError, TorquerigError, UnknownNameError
from torquerig.orders.angle.suspicions import suspicions_in
from torquerig.orders.kinematics.kinematic_lines import KinematicLine, Kinematics
from torquerig.plain_table import grid, wrapped
from torquerig.recordings.files import open_stream
from torquerig.recordings.files.gz import TEXT_ENDINGS
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.inspection.file_contents import file_contents
from torquerig.recordings.inspection.recording_info import RecordingInfo, stream_info
from torquerig.recordings.inspection.stretch_faults import head_of, sound_stretch
from torquerig.recordings.recording import Recording
from torquerig.reporting.json_results.info import InfoResult, RecordingResult, unreadable, unusable, usable

if TYPE_CHECKING:
    from torquerig.orders.angle.best_angle import MotorSpeed

LARGE = 2**26
"""From this size on [bytes] info says that a file could not be read in pieces."""


@click.command("info")
@click.argument("recordings", nargs=-1, required=False, type=click.Path(path_type=Path))
@click.option("--picture", type=click.Path(path_type=Path), default=None,
              help="Draw channels, spectrum and levels of one recording: .svg or .png.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite an earlier picture of that name.")
@json_option("info", reads=("recordings",), bare="recordings")
def command(*, recordings: tuple[Path, ...], picture: Path | None, force: bool) -> InfoResult | Partly:
    """Show channels, rate, length, levels and speed of RECORDINGS, and their faults with sample numbers.

    A folder stands for all recordings in it; texts without a table of numbers are listed as no recordings. Of a file
    that cannot be used as it is, info shows what is in it and what is missing; torquerig sheet drafts the sidecar.
    Faults are gaps in time, samples without a number, clipping, dropouts, spikes and constant stretches, and in the
    first stretch of a torque all faults that diagnose finds in samples. A long recording is read block by block.

    Example: torquerig info run1.tdms
    """
    if not recordings:
        raise click.UsageError("Missing argument 'RECORDINGS...'.", ctx=click.get_current_context())
    named = [path for one in recordings for path in recordings_in(one)]
    # info run.* names the sidecars too
    paths = [path for path in named if path.suffix.lower() != ".yaml" or len(named) == 1]
    # a text in a folder may be anything: a licence, notes
    folders = {one for one in recordings if one.is_dir()}
    may_be_other = {path for path in paths if path.parent in folders and path.suffix.lower() in TEXT_ENDINGS}
    if picture is not None:
        from torquerig.reporting.figures.picture import check_picture

        if len(paths) > 1:
            raise InputError(f"{picture}: one picture shows one recording, and {len(paths)} are named; name one")
        check_picture(picture, overwrite=force)
    if not wants_json():
        _show_all(paths, may_be_other, picture, force=force)
        return InfoResult(())
    result = InfoResult(tuple(recording_result(path) for path in paths))
    if picture is not None:
        _show_all(paths, may_be_other, picture, force=force)
    unread = [one for one in result.recordings if not one.columns and Path(one.path) not in may_be_other]
    if unread:
        return Partly(result, RecordingError(f"{len(unread)} of {len(paths)} files cannot be read; the JSON says why"))
    return result


def _show_all(paths: Sequence[Path], may_be_other: Collection[Path], picture: Path | None, *, force: bool) -> None:
    """Print each file; raise at the end where some cannot be read, and at once where only one is named."""
    failed, others = 0, []
    for count, path in enumerate(paths):
        if count:
            click.echo()
        try:
            _show(path, picture, force=force)
        except TorquerigError as error:
            if path in may_be_other:
                others.append(path.name)
                click.echo(f"{path}: not a recording: {str(error).removeprefix(f'{path}: ')}")
                continue
            if len(paths) == 1:
                raise
            failed += 1
            click.echo(f"{path}: cannot be read: {error}")
    if len(others) == len(paths):
        raise RecordingError(f"none of the {len(paths)} files is a recording; the reasons are above")
    if failed:
        raise RecordingError(f"{failed} of {len(paths)} files cannot be read; the reasons are above")


def _length(info: RecordingInfo) -> str:
    """Return rate and length of a recording; where it has pauses, the rate between them and the whole time too."""
    if info.pauses is None:
        return f"{info.samples} samples at {info.sample_rate:g} Hz, {info.duration:g} s"
    return (
        f"{info.samples} samples at {info.sample_rate:g} Hz between pauses, {info.duration:g} s of them; "
        f"{info.span:g} s from the first to the last sample"
    )


def _uses(stream: RecordingStream) -> dict[str, str]:
    """Return of each channel its role and part as the sidecar states them; empty where it states one part at most."""
    stated = {name: one for name, one in stream.entries.items() if (one.of or one.role) and not one.truth}
    if len(stated) < 2 and not any(one.role for one in stated.values()):
        return {}
    return {
        name: " ".join([*([one.role] if one.role else []), *([f"of {one.of}"] if one.of else [])])
        for name, one in stated.items()
    }


def recording_result(path: Path) -> RecordingResult:
    """Return all that is known of one file; a file that cannot be read is its path and the problem."""
    try:
        contents = file_contents(path)
    except TorquerigError as error:
        return unreadable(path.as_posix(), str(error))
    if contents.problem:
        return unusable(contents)
    try:
        stream = open_stream(path)
        info, head = stream_info(stream), head_of(stream)
    except RecordingError as error:
        return unusable(replace(contents, problem=str(error)))
    speed, text = _speed(stream, head)
    return usable(contents, stream, info, speed=speed, speed_text=text, suspicions=suspicions_in(info, head)[0])


def _show(path: Path, picture: Path | None, *, force: bool) -> None:
    """Print one file; where it cannot be used as it is, its contents and what is missing."""
    try:
        stream = open_stream(path)
        info = stream_info(stream)
    except (InputError, RecordingError):
        if picture is not None:
            raise
        show_contents(file_contents(path))
        return
    click.echo(f"{path}: {_length(info)}")
    uses = _uses(stream)
    rows = [
        ["channel", "quantity", "unit", *(["use"] if uses else []), "minimum", "mean", "maximum", "std", "known by"]
    ]
    for name, one in info.channels.items():
        figures = (f"{number:.6g}" for number in (one.minimum, one.mean, one.maximum, one.std))
        entry = stream.entries[name]
        used = [uses.get(name, "")] if uses else []
        rows.append([name, one.quantity, one.unit, *used, *figures, known_by(entry.reason, entry.missing)])
    click.echo(grid(rows))
    missing = {name: (one.reason, one.missing) for name, one in stream.entries.items()}
    show_reading(stream.table.notes, stream.table.skipped, missing)
    head = head_of(stream)
    speed, speed_text = _speed(stream, head)
    click.echo(wrapped(speed_text))
    for sentence in _aliases(stream, head):
        click.echo(wrapped(sentence))
    if stream.table.read_whole and path.stat().st_size > LARGE:
        click.echo(f"read whole: {stream.table.read_whole}")
    print_suspicions(info, head)
    if picture is not None:
        _draw(info, stream, speed, picture, force=force)


def _speed(stream: RecordingStream, head: Recording) -> tuple[float | None, str]:
    """Return the mean motor speed over the first block [rad/s], and a text with its 95 % interval and its source."""
    from torquerig.orders.angle.best_angle import best_motor_speed

    first, head = sound_stretch(head)
    try:
        found = best_motor_speed(head, _lines(stream))
    except TorquerigError as error:
        is_linear_axis = stream.run.speed is None and any(head.find(each) for each in ("position", "velocity"))
        why = "a linear axis has no motor speed" if is_linear_axis else error
        return stream.run.speed, f"motor speed: not found ({why})"
    whole = stream.samples is not None and stream.samples <= head.samples
    where = "" if whole else f" over {_span(first, head)}"
    set_point = stream.run.speed_rpm
    stated = "" if not set_point else f"; set-point {abs(set_point):.6g} rpm"
    return found.value, f"motor speed: {_with_interval(found)}{where} ({found.origin}{stated})"


def _aliases(stream: RecordingStream, head: Recording) -> list[str]:
    """Return a sentence for each line that may be the alias of a line of the rig above half the sample rate."""
    from torquerig.orders.analysis.frequency_lines import possible_aliases
    from torquerig.orders.analysis.labels import label_of
    from torquerig.orders.angle.best_angle import best_motor_speed

    head, lines = sound_stretch(head)[1], _lines(stream)
    try:
        speed = best_motor_speed(head, lines)
        ratio = stream.run.gear_ratio or 1.0
        half_width = speed.half_width if isfinite(speed.half_width) else 0.0
        turns = speed.value / (2 * pi * ratio)
        found = possible_aliases(head, lines, turns_per_second=turns, half_width=half_width)
    except TorquerigError:
        return []  # without a torque or a speed there is no line of the rig to compare with
    return [
        f"the line at {line.frequency:.6g} Hz ({line.amplitude:.3g} N*m) may be the alias of {label_of([cause])} at "
        f"{cause.output_order * turns:.6g} Hz, above half the sample rate"
        for line, cause in found
    ]


def _with_interval(speed: MotorSpeed) -> str:
    """Return a speed in rpm and half its 95 % interval in %, with digits that do not round it out of the interval."""
    rpm = speed.value * 30 / pi
    if not (isfinite(speed.half_width) and speed.half_width > 0):
        return f"{rpm:.6g} rpm"
    digits = max(6, ceil(-log10(speed.half_width)) + 2)
    step = 10.0 ** (floor(log10(100 * speed.half_width)) - 1)
    return f"{rpm:.{digits}g} rpm +- {ceil(100 * speed.half_width / step - 1e-9) * step:.2g} %"


def _span(first: int, head: Recording) -> str:
    if first == 0:
        return f"the first {head.duration:.3g} s"
    return f"samples {first}..{first + head.samples - 1}, the longest stretch without gaps"


def _lines(stream: RecordingStream) -> tuple[KinematicLine, ...]:
    """Return the order lines of the motor and gear ratio in the sidecar, as far as known."""
    pole_pairs, slots = None, None
    if stream.run.motor is not None:
        with suppress(UnknownNameError):
            pole_pairs, slots, _ = winding_of(catalog_for(None, ()).motor(stream.run.motor))
    return Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=stream.run.gear_ratio or 1.0).lines()


def _draw(info: RecordingInfo, stream: RecordingStream, speed: float | None, path: Path, *, force: bool) -> None:
    from torquerig.reporting.figures.info_figure import info_figure
    from torquerig.reporting.figures.picture import write_picture

    measured = [name for name, one in info.channels.items() if not one.truth] or list(info.channels)
    main = next((name for name in measured if info[name].quantity in ("torque", "force")), measured[0])
    output_speed = abs(speed) / (stream.run.gear_ratio or 1.0) if speed else None
    write_picture(info_figure(info, main=main, output_speed=output_speed), path, overwrite=force)
    click.echo(f"wrote {path}")
