"""``torquerig ordermap``: order lines and fixed frequencies of a recording."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import click
import numpy as np

from torquerig.cli.common_options import catalog_option, channel_option
from torquerig.cli.completions import gearbox_names, motor_names
from torquerig.cli.json_option import json_option
from torquerig.cli.suspicions import print_suspicions
from torquerig.errors import InputError, RecordingError, UnitError
from torquerig.orders.analysis.angle_resampling import FEWEST_TURNS, output_turns, over_angle
from torquerig.orders.analysis.frequency_lines import frequency_lines
from torquerig.orders.analysis.labels import label_of
from torquerig.orders.analysis.line_detection import DetectedLine, detected_lines
from torquerig.orders.analysis.line_domain import DECIDED
from torquerig.orders.analysis.order_spectrum import line_amplitude, order_spectrum
from torquerig.orders.analysis.peaks import floor_of
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.orders.angle.measured_angle import MotorAngle
from torquerig.orders.kinematics.kinematic_lines import KinematicLine, Kinematics
from torquerig.plain_table import cut, fixed, grid, rms_size, wrapped
from torquerig.recordings.files import read_recording
from torquerig.recordings.inspection.recording_info import recording_info
from torquerig.recordings.recording import Recording
from torquerig.reporting.json_results.ordermap import (
    KnownOrder,
    OrdermapResult,
    found_lines,
    lines_over_frequency,
)
from torquerig.reporting.json_results.values import Missing, Quantity
from torquerig.rig.assembly import Rig
from torquerig.scenario.recorded.recorded_drive import recorded_drive
from torquerig.units import parse_quantity

_AS_THEY_ARE = "the lines are those of the samples as they are"
_ENDS = (1, 99)  # [%] quantiles of the speed that are printed as its range


@click.command("ordermap")
@click.argument("recording", type=click.Path(path_type=Path))
@click.option(
    "--motor", shell_complete=motor_names, default=None, help="Motor of the catalog, if the sidecar does not name it."
)
@click.option(
    "--ratio", type=float, default=None, help="Motor turns per output turn, if the sidecar has no gear_ratio."
)
@click.option(
    "--gearbox", shell_complete=gearbox_names, default=None, help="Gearbox of the catalog, for its gear mesh lines."
)
@click.option("--scenario", type=click.Path(path_type=Path), default=None,
              help="Scenario of the rig, for its gear mesh lines and its modes in the Campbell diagram.")  # fmt: skip
@click.option(
    "--harmonics",
    type=click.IntRange(1, 20),
    default=4,
    show_default=True,
    help="Number of harmonics of each family of lines.",
)
@click.option("--mains", default="50 Hz", show_default=True, help="Mains frequency.")
@click.option("--picture", type=click.Path(path_type=Path), default=None,
              help="Draw order spectrum, order map and Campbell diagram: .svg or .png.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite an earlier picture of that name.")
@channel_option
@catalog_option
@json_option("ordermap", reads=("recording", "scenario"))
def command(
    *, recording: Path, motor: str | None, ratio: float | None, gearbox: str | None, scenario: Path | None,
    harmonics: int, mains: str, picture: Path | None, force: bool, channel: str | None, catalogs: tuple[Path, ...],
) -> OrdermapResult:  # fmt: skip
    """List the spectral lines of RECORDING and decide for each whether its order or its frequency is constant.

    When the speed changes, a line of the shaft keeps its order. A line of the mains or of an electronic clock keeps its
    frequency. Each line is tested on both axes. A run at constant speed cannot decide.

    Example: torquerig ordermap ramp.parquet --scenario scenarios/wear_rig.yaml --picture orders.svg
    """
    if picture is not None:
        from torquerig.reporting.figures.picture import check_picture

        check_picture(picture, overwrite=force)
    grid_frequency = _hertz(mains)
    read = read_recording(recording)
    read = read if channel is None else read.comparing(channel)
    drive = recorded_drive(read, motor=motor, ratio=ratio, gearbox=gearbox, scenario=scenario, catalogs=catalogs)
    kinematics, read = drive.kinematics, replace(read, run=drive.run_of(read.run))
    lines = kinematics.lines(harmonics)
    try:
        angle = best_motor_angle(read, lines, ratio=kinematics.ratio)
    except RecordingError as error:
        if picture is not None:
            raise
        return _without_orders(read, mains=grid_frequency, reason=str(error), assumed=drive.assumed)
    turns = output_turns(angle.values, ratio=kinematics.ratio)
    found = detected_lines(read, turns, kinematics, harmonics=harmonics, mains=grid_frequency)
    click.echo(_about(read, angle, turns, kinematics))
    known, size, unit = known_orders(read, turns, kinematics, lines), rms_size(read.torque()), read.torque_unit()
    click.echo(_known_table(known, size=size, unit=unit) + "\n")
    click.echo(_found_table(found, size=size, unit=unit))
    notes = (*drive.assumed, *_sentences(found, kinematics))
    for sentence in notes:
        click.echo(wrapped(sentence))
    suspicious = print_suspicions(recording_info(read), read, note=_AS_THEY_ARE)
    if picture is not None:
        from torquerig.reporting.figures.order_figure import order_figure, order_picture
        from torquerig.reporting.figures.picture import write_picture

        shown = order_picture(read, turns, lines=lines, found=found, ratio=kinematics.ratio,
                              counted=kinematics.fastest_shaft[1], modes=_modes_of(drive.rig))  # fmt: skip
        write_picture(order_figure(shown, title=f"{read.name}: orders of the torque"), picture, overwrite=force)
        click.echo(f"wrote {picture}")
    return OrdermapResult(
        recording=read.name, duration_s=read.duration, speed_rpm=_speeds(read, turns, 60 * kinematics.ratio),
        output_turns=float(turns[-1]), angle_origin=angle.origin, known=known, notes=notes,
        lines=found_lines(found, unit=unit), suspicions=tuple(suspicious),
    )  # fmt: skip


def _without_orders(read: Recording, *, mains: float, reason: str, assumed: Sequence[str]) -> OrdermapResult:
    """Print and return the lines over frequency alone, and why there are no orders."""
    found = frequency_lines(read, mains=mains)
    click.echo(f"{read.name}: {read.duration:.4g} s; one bin is {1 / read.duration:.3g} Hz")
    size = rms_size(read.torque())
    if found:
        rows = [["at Hz", f"amplitude {read.torque_unit()}", "above floor dB", "cause"]]
        for one in found:
            multiple = f"{one.mains_multiple} x mains" if one.mains_multiple else "no known cause"
            amplitude = fixed(one.amplitude, scale=size, digits=6)
            rows.append([f"{one.frequency:.6g}", amplitude, f"{one.above_dB:.1f}", multiple])
        click.echo(grid(rows))
    else:
        click.echo("no line exceeds the noise floor")
    click.echo(wrapped(f"no orders: {reason}"))
    return OrdermapResult(
        recording=read.name, duration_s=read.duration, speed_rpm=Missing(reason), output_turns=Missing(reason),
        angle_origin="", known=(), lines=lines_over_frequency(found, unit=read.torque_unit()),
        notes=(*assumed, f"no orders: {reason}"), suspicions=(),
    )  # fmt: skip


def _modes_of(rig: Rig | None) -> dict[str, float]:
    """Return the modes of the scenario's rig by name [Hz]; empty without one."""
    if rig is None:
        return {}
    from torquerig.simulation.twin.linear_twin import twin_of

    modes = enumerate(twin_of(rig).modes(), start=1)
    return {f"mode {number}": mode.damped for number, mode in modes if mode.damped}


def _about(read: Recording, angle: MotorAngle, turns: np.ndarray, kinematics: Kinematics) -> str:
    low, high = _speeds(read, turns, 1.0)
    travel = read.run.travel_per_turn if read.torque_unit() == "N" else None
    if travel is None:
        per_turn, unit, moved = 60 * kinematics.ratio, "rpm", kinematics.input_name
    else:
        per_turn, unit, moved = 1e3 * travel, "mm/s", f"{1e3 * travel:.6g} mm each, what is measured"
    return wrapped(
        f"{read.name}: {read.duration:.4g} s, {turns[-1]:.4g} turns of the output shaft, {moved} at "
        f"{low * per_turn:.5g} to {high * per_turn:.5g} {unit}, {angle.origin}; one bin is "
        f"{1 / turns[-1]:.3g} orders or {1 / read.duration:.3g} Hz"
        f"{_shafts(kinematics)}{_slow_output(turns, kinematics)}"
    )


def _speeds(read: Recording, turns: np.ndarray, per_turn: float) -> tuple[float, float]:
    """Return a low and a high quantile of the output turns per second, times ``per_turn``."""
    step = max(round(0.05 * read.sample_rate), 1)
    speeds = np.diff(turns[::step]) * read.sample_rate / step
    low, high = np.percentile(speeds, _ENDS) if speeds.size else (0.0, 0.0)
    return float(low * per_turn), float(high * per_turn)


def _slow_output(turns: np.ndarray, kinematics: Kinematics) -> str:
    """Return how often the fastest shaft turns, where the output shaft turns too little for its own orders."""
    name, per_turn = kinematics.fastest_shaft
    if turns[-1] >= FEWEST_TURNS or per_turn == 1:
        return ""
    return (
        f". The output shaft turns fewer than {FEWEST_TURNS:g} times: its low orders cannot be seen. The {name} "
        f"turns {turns[-1] * per_turn:.4g} times"
    )


def _shafts(kinematics: Kinematics) -> str:
    """Return the turns of the shafts between motor and output, and of branches, where there are some."""
    others = kinematics.shaft_turns
    if len(others) <= 2:
        return ""
    return "; turns per output turn: " + ", ".join(f"{name} {turns:.6g}" for name, turns in others.items())


def known_orders(
    read: Recording, turns: np.ndarray, kinematics: Kinematics, lines: Sequence[KinematicLine]
) -> tuple[KnownOrder, ...]:
    """Return each order with a known cause: its amplitude, and its level above the noise floor."""
    torque = read.torque()
    top = 0.4 * read.sample_rate / float(np.max(np.diff(turns)) * read.sample_rate)
    spectrum = order_spectrum(over_angle(read, turns, fastest=kinematics.fastest_shaft[1]), highest=top)
    floor = floor_of(spectrum.amplitudes)
    places: dict[float, list[KinematicLine]] = {}
    for line in sorted(lines, key=lambda line: line.output_order):
        places.setdefault(float(f"{line.output_order:.9g}"), []).append(line)
    found = []
    for order, causes in places.items():
        if order > min(top, float(spectrum.places[-1])) or order * turns[-1] < 2:
            continue
        amplitude = line_amplitude(torque, turns, order)
        above = 20 * np.log10(max(amplitude, 1e-300) / floor[round(order / spectrum.width)])
        shown = Quantity(float(amplitude), read.torque_unit())
        found.append(KnownOrder(order, causes[0].motor_order, shown, float(above), label_of(causes)))
    return tuple(found)


def _known_table(known: Sequence[KnownOrder], *, size: float, unit: str) -> str:
    rows = [["output order", "motor order", f"amplitude {unit}", "above floor dB", "cause"]]
    for one in known:
        assert isinstance(one.amplitude.value, float)
        shown = fixed(one.amplitude.value, scale=size, digits=6)
        rows.append([f"{one.output_order:.6g}", f"{one.motor_order:.6g}", shown, f"{one.above_floor_dB:.1f}",
                     cut(one.cause, 70)])  # fmt: skip
    return grid(rows)


def _found_table(found: Sequence[DetectedLine], *, size: float, unit: str) -> str:
    if not found:
        return "no line exceeds the noise floor"
    rows = [["constant", "at", f"amplitude {unit}", "line power over order %", "over Hz %", "order/Hz dB", "cause"]]
    for one in found:
        axis = "order" if one.detected_over == "order" else "Hz"
        rows.append([
            "undecided" if one.axis == "either" else one.axis, f"{one.place:.6g} {axis}",
            fixed(one.amplitude, scale=size, digits=6), f"{100 * one.domain.by_order:.1f}",
            f"{100 * one.domain.by_frequency:.1f}",
            f"{one.domain.contrast_dB:+.1f}", cut(one.label or "no known cause", 110),
        ])  # fmt: skip
    return grid(rows)


def _sentences(found: Sequence[DetectedLine], kinematics: Kinematics) -> list[str]:
    sentences = [f"No {family.replace('_', ' ')} lines: {reason}." for family, reason in kinematics.left_out.items()]
    undecided = [one for one in found if one.axis == "either"]
    if undecided:
        sentences.insert(0, f"{len(undecided)} lines are undecided (order and frequency within {DECIDED:g} dB): "
                            f"the speed "
                       "changes too little to separate orders from fixed frequencies. Record a ramp.")  # fmt: skip
    return sentences


def _hertz(text: str) -> float:
    try:
        value = parse_quantity(text, "Hz")
    except UnitError as error:
        raise UnitError(f"--mains: {error}") from None
    if not value > 0:
        raise InputError(f"--mains: {text} is not more than 0; write for example '50 Hz'")
    return value
