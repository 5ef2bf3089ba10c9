"""``torquerig filter``: apply filter chains to a recording and show their effect."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import click

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli.common_options import catalog_option, channel_option
from torquerig.cli.completions import chain_names, gearbox_names, motor_names
from torquerig.cli.filter_parts.blocks import blocks_for, described, filter_long
from torquerig.cli.filter_parts.evaluation import (
    bands_option,
    evaluation_pictures,
    hit_decay_option,
    print_evaluations,
    stated_scale,
)
from torquerig.cli.filter_parts.text import print_effects
from torquerig.cli.json_option import json_option
from torquerig.cli.suspicions import print_suspicions, print_suspicions_of_start
from torquerig.errors import InputError, UnitError, did_you_mean
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.chains.renamed_chains import current_chain
from torquerig.filters.filter_effect import FilterEffect, chain_effect
from torquerig.metrics.truth_error import true_load, truth_error
from torquerig.orders.angle.measured_angle import has_motion
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.plain_table import wrapped
from torquerig.recordings.files import check_target, open_stream, read_recording, write_recording
from torquerig.recordings.files.blocks import Blocking
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.inspection.recording_info import recording_info
from torquerig.recordings.recording import Recording
from torquerig.recordings.set_point import missing_speed, set_point_speed
from torquerig.renamed import current_name
from torquerig.reporting.json_results.filter import ChainEvaluation, FilterResult, chain_effects
from torquerig.reporting.json_results.simulate import named
from torquerig.reporting.json_results.values import Quantity
from torquerig.scenario.recorded.recorded_drive import RecordedDrive, chains_for, recorded_drive
from torquerig.units import parse_quantity

_AS_THEY_ARE = "suspicious samples are filtered as they are"


@click.command("filter")
@click.argument("recording", type=click.Path(path_type=Path))
@click.option(
    "--chain",
    "names",
    shell_complete=chain_names,
    multiple=True,
    help="Filter chain to apply; repeatable. Default: report_filter_code and report_filter_text.",
)
@click.option(
    "--filters",
    type=click.Path(path_type=Path),
    default=None,
    help="YAML file of filter chains. Default: the shipped scenarios/filters.yaml.",
)
@click.option(
    "--motor", shell_complete=motor_names, default=None, help="Motor of the catalog, if the sidecar does not name it."
)
@click.option(
    "--ratio", type=float, default=None, help="Motor turns per output turn, if the sidecar has no gear_ratio."
)
@click.option(
    "--gearbox",
    shell_complete=gearbox_names,
    default=None,
    help="Gearbox of the catalog, for its ratio and its gear mesh lines.",
)
@click.option(
    "--scenario",
    type=click.Path(path_type=Path),
    default=None,
    help="Scenario of the rig: the lines of all its shafts, meshes, belts and bearings.",
)
@click.option("--out", type=click.Path(path_type=Path), default=None, help="Write the filtered recording (one chain).")
@click.option(
    "--picture", type=click.Path(path_type=Path), default=None, help="Draw time signal and spectrum before and after."
)
@click.option(
    "--evaluate", is_flag=True, help="Evaluate each chain: placebo test, step response, error to the true load, figure."
)
@click.option("--judge", "judge", is_flag=True, hidden=True)
@hit_decay_option
@bands_option
@click.option(
    "--block",
    default=None,
    metavar="TIME",
    help="Filter in blocks of this length, such as '60 s'. Default for a long recording: blocks of a fitting length.",
)
@click.option("--force", is_flag=True, help="Overwrite an earlier recording or picture of that name.")
@channel_option
@catalog_option
@json_option("filter", reads=("recording", "filters", "scenario"))
def command(
    *, recording: Path, names: tuple[str, ...], filters: Path | None, motor: str | None, ratio: float | None,
    gearbox: str | None, scenario: Path | None, out: Path | None, picture: Path | None, evaluate: bool, judge: bool,
    hit_decay: float | None, bands: tuple[float, ...] | None, block: str | None, force: bool, channel: str | None,
    catalogs: tuple[Path, ...],
) -> FilterResult:  # fmt: skip
    """Apply filter chains to RECORDING and show the change of standard deviation, mean, energy and order lines.

    A smaller standard deviation does not prove less noise: any twenty notches reduce it. The error to the true load is
    known only for a simulated recording with truth channels. --evaluate lists this error by frequency band, energy,
    hits and delay. It also compares each chain with the same chain at orders without lines (placebo test).

    A long recording is filtered block by block with constant memory. Figures and evaluation then use a section from its
    middle.

    Example: torquerig filter run1.parquet --chain order_lines_low_pass --out filtered.parquet
    """
    if judge:
        evaluate = True
        current_name("--judge", {"--judge": "--evaluate"}, what="option")
    scale = stated_scale(hit_decay, bands)
    _check_targets(recording, names, out, None if evaluate else picture, force=force)
    names = names or ("report_filter_code", "report_filter_text")
    panels = evaluation_pictures(recording, names, picture, force=force) if evaluate else {}
    stream = open_stream(recording)
    stream = stream if channel is None else stream.comparing(channel)
    sheet = described(stream)
    drive = recorded_drive(sheet, scenario=scenario, motor=motor, ratio=ratio, gearbox=gearbox, catalogs=catalogs)
    kinematics, stream = drive.kinematics, replace(stream, run=drive.run_of(stream.run))
    sheet = replace(sheet, run=stream.run)
    known = chains_for(drive, filters or shipped_scenarios() / "filters.yaml", names)
    chains = [_chain(name, known) for name in names]
    if picture is not None and not evaluate:
        _refuse_picture_without_speed(sheet)
    blocking = blocks_for(stream, chains, block=None if block is None else _seconds(block))
    if blocking is None:
        made = _filtered_whole(recording, chains, drive, channel=channel, out=out, force=force)
    else:
        made = _filtered_in_blocks(stream, chains, kinematics, blocking, out=out, force=force)
    for sentence in drive.assumed:
        click.echo(wrapped(sentence))
    evaluations: tuple[ChainEvaluation, ...] = ()
    if evaluate:
        where = "" if blocking is None else ", a section from the middle"
        evaluations = print_evaluations(made.before, chains, kinematics, panels, where=where, force=force, scale=scale)
    elif picture is not None:
        _draw(made.before, made.after, chains[0], kinematics, picture, force=force)
    pictures = list(panels.values()) if evaluate else [picture] if picture is not None else []
    first, unit = made.effects[0], made.before.torque_unit()
    return FilterResult(
        recording=sheet.name, samples=made.samples, std=Quantity(first.std_before, unit),
        mean=Quantity(first.mean_before, unit), speed_origin=first.speed_origin,
        chains=chain_effects(chains, made.effects, made.errors, unit=unit), evaluations=evaluations,
        notes=tuple(drive.assumed), written=named([*made.written, *pictures]),
    )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class _Filtered:
    """The recording (or a section of it) before and after the first chain, and effects and errors of each chain."""

    before: Recording
    after: Recording
    effects: Sequence[FilterEffect]
    errors: Sequence[float] | None
    samples: int
    written: Sequence[Path]


def _filtered_whole(
    path: Path, chains: Sequence[Chain], drive: RecordedDrive, *, channel: str | None, out: Path | None, force: bool
) -> _Filtered:
    """Filter, print and write."""
    kinematics, before = drive.kinematics, read_recording(path)
    before = replace(before, run=drive.run_of(before.run))
    before = before if channel is None else before.comparing(channel)
    print_suspicions(recording_info(before), before, note=_AS_THEY_ARE)
    results = [chain.apply(before) for chain in chains]
    effects = [
        chain_effect(before, after, ratio=kinematics.ratio, lines=chain.lines)
        for chain, after in zip(chains, results, strict=True)
    ]
    errors = None if true_load(before) is None else [truth_error(after, before) for after in results]
    print_effects(path, before, chains, effects, errors, samples=before.samples, ratio=kinematics.ratio)
    written: Sequence[Path] = []
    if out is not None:
        written = write_recording(results[0], out, overwrite=force)
        click.echo(f"wrote {' and '.join(str(path) for path in written)}")
    return _Filtered(
        before=before, after=results[0], effects=effects, errors=errors, samples=before.samples, written=written
    )


def _filtered_in_blocks(
    stream: RecordingStream, chains: Sequence[Chain], kinematics: Kinematics, blocking: Blocking, *, out: Path | None,
    force: bool,
) -> _Filtered:  # fmt: skip
    """Filter and write block by block; before and after are a section of the recording."""
    print_suspicions_of_start(stream, note=_AS_THEY_ARE)
    made = filter_long(stream, chains, blocking, ratio=kinematics.ratio, out=out, force=force)
    seconds, overlap = (samples / stream.sample_rate for samples in (blocking.samples, blocking.overlap))
    click.echo(f"filtered in blocks of {seconds:.4g} s with an overlap of {overlap:.3g} s on each side")
    print_effects(
        stream.path,
        described(stream),
        chains,
        made.effects,
        made.errors,
        samples=made.samples,
        ratio=kinematics.ratio,
    )
    return _Filtered(
        before=made.section.before, after=made.section.after[0], effects=made.effects, errors=made.errors,
        samples=made.samples, written=made.written,
    )  # fmt: skip


def _check_targets(
    recording: Path, names: tuple[str, ...], out: Path | None, picture: Path | None, *, force: bool
) -> None:
    if (out or picture) and len(names) != 1:
        raise InputError("--out and --picture need exactly one --chain")
    if out is not None:
        check_target(out, overwrite=force, inputs=[recording])
    if picture is not None:
        from torquerig.reporting.figures.picture import check_picture

        check_picture(picture, overwrite=force)


def _chain(written: str, known: Mapping[str, Chain]) -> Chain:
    name = current_chain(written)
    if name not in known:
        raise InputError(f"--chain {name}: unknown filter chain; {did_you_mean(name, known)}")
    return known[name]


def _seconds(written: str) -> float:
    try:
        seconds = parse_quantity(written, "s")
    except UnitError as error:
        raise UnitError(f"--block: {error}") from None
    if not seconds > 0:
        raise InputError(f"--block: {written} is not more than 0; write for example '60 s'")
    return seconds


def _draw(
    before: Recording, after: Recording, chain: Chain, kinematics: Kinematics, path: Path, *, force: bool
) -> None:
    from torquerig.reporting.figures.before_after_figure import before_after_figure
    from torquerig.reporting.figures.picture import write_picture

    lines = chain.lines or kinematics.lines()
    speed = set_point_speed(before, "the order lines of a picture")
    figure = before_after_figure(before, after, lines=lines, motor_speed=speed, ratio=kinematics.ratio)
    write_picture(figure, path, overwrite=force)
    click.echo(f"wrote {path}")


def _refuse_picture_without_speed(sheet: Recording) -> None:
    if not sheet.run.speed and not has_motion(sheet):
        raise InputError(f"{sheet.name}: {missing_speed(sheet, 'the order lines of a picture')}")
