"""``torquerig ordermap``: what lines a recording shows, which belong to the shaft and which to the clock."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np

from torquerig.catalog.search import catalog_for
from torquerig.cli.inputs import catalog_option
from torquerig.errors import InputError, UnitError
from torquerig.orders.analysis.angle_resampling import output_turns, over_angle
from torquerig.orders.analysis.labels import label_of
from torquerig.orders.analysis.line_detection import DetectedLine, detected_lines
from torquerig.orders.analysis.line_domain import DECIDED
from torquerig.orders.analysis.order_spectrum import line_amplitude, order_spectrum
from torquerig.orders.analysis.peaks import floor_of
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.orders.angle.measured_angle import MotorAngle
from torquerig.orders.kinematics.kinematic_lines import KinematicLine, Kinematics
from torquerig.plain_table import cut, grid, wrapped
from torquerig.recordings.files import read_recording
from torquerig.recordings.recording import Recording
from torquerig.scenario.recording_lines import kinematics_of_recording
from torquerig.units import parse_quantity

if TYPE_CHECKING:
    pass

_ENDS = (1, 99)  # per cent of the samples between whose speeds the range is told


@click.command("ordermap")
@click.argument("recording", type=click.Path(path_type=Path))
@click.option("--motor", default=None, help="Motor of the catalog, where the sidecar does not name it.")
@click.option("--ratio", type=float, default=None, help="Motor turns per output turn, where the sidecar does not say.")
@click.option("--gearbox", default=None, help="Gearbox of the catalog, for the lines of its teeth.")
@click.option("--scenario", type=click.Path(path_type=Path), default=None,
              help="Scenario of the rig: its teeth, and its modes in the Campbell diagram.")  # fmt: skip
@click.option("--harmonics", type=click.IntRange(1, 20), default=4, show_default=True, help="Lines of each family.")
@click.option("--mains", default="50 Hz", show_default=True, help="Frequency of the grid.")
@click.option("--picture", type=click.Path(path_type=Path), default=None,
              help="Draw order spectrum, order map and Campbell diagram: .svg or .png.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite an earlier picture of that name.")
@catalog_option
def command(
    *, recording: Path, motor: str | None, ratio: float | None, gearbox: str | None, scenario: Path | None,
    harmonics: int, mains: str, picture: Path | None, force: bool, catalogs: tuple[Path, ...],
) -> None:  # fmt: skip
    """Show the lines of RECORDING over the order of its shaft, and tell them from fixed frequencies.

    A line of the shaft stays at its order when the speed changes, a line of the grid or of an electronic clock at its
    frequency. Which of the two axes gathers a line more is tested line by line; a steady run cannot tell.
    """
    if picture is not None:
        from torquerig.reporting.figures.picture import check_picture

        check_picture(picture, overwrite=force)
    grid_frequency = _hertz(mains)
    read = read_recording(recording)
    kinematics, modes = _known_of(read, motor=motor, ratio=ratio, gearbox=gearbox, scenario=scenario, catalogs=catalogs)
    lines = kinematics.lines(harmonics)
    angle = best_motor_angle(read, lines, ratio=kinematics.ratio)
    turns = output_turns(angle.values, ratio=kinematics.ratio)
    found = detected_lines(read, turns, lines, mains=grid_frequency)
    click.echo(_about(read, angle, turns, kinematics.ratio))
    click.echo(_known_table(read, turns, lines) + "\n")
    click.echo(_found_table(found))
    for sentence in _sentences(found, kinematics):
        click.echo(wrapped(sentence))
    if picture is not None:
        from torquerig.reporting.figures.order_figure import order_figure, order_picture
        from torquerig.reporting.figures.picture import write_picture

        shown = order_picture(read, turns, lines=lines, found=found, ratio=kinematics.ratio, modes=modes)
        write_picture(order_figure(shown, title=f"{read.name}: orders of the torque"), picture, overwrite=force)
        click.echo(f"wrote {picture}")


def _known_of(
    read: Recording, *, motor: str | None, ratio: float | None, gearbox: str | None, scenario: Path | None,
    catalogs: Sequence[Path],
) -> tuple[Kinematics, dict[str, float]]:  # fmt: skip
    """Return what the lines follow from, and the modes of the scenario's rig by name."""
    if scenario is not None:
        if motor is not None or ratio is not None or gearbox is not None:
            raise InputError("--scenario names motor and gearbox already; leave --motor, --ratio and --gearbox out")
        return _of_scenario(scenario, catalogs)
    catalog = catalog_for(None, catalogs)
    return kinematics_of_recording(read, catalog, motor=motor, ratio=ratio, gearbox=gearbox)[0], {}


def _of_scenario(scenario: Path, catalogs: Sequence[Path]) -> tuple[Kinematics, dict[str, float]]:
    from torquerig.document import read_document
    from torquerig.scenario.kinematics import kinematics_of
    from torquerig.scenario.reading import read_scenario
    from torquerig.simulation.twin.linear_twin import twin_of

    made = read_scenario(read_document(scenario), catalog_for(scenario, catalogs), seed=1)
    modes = {
        f"mode {number}": mode.damped for number, mode in enumerate(twin_of(made.rig).modes(), start=1) if mode.damped
    }
    return kinematics_of(made.rig), modes


def _about(read: Recording, angle: MotorAngle, turns: np.ndarray, ratio: float) -> str:
    step = max(round(0.05 * read.sample_rate), 1)
    speeds = np.diff(turns[::step]) * read.sample_rate / step * ratio * 60
    low, high = np.percentile(speeds, _ENDS) if speeds.size else (0.0, 0.0)
    return wrapped(
        f"{read.name}: {read.duration:.4g} s, {turns[-1]:.4g} turns of the output shaft, motor at {low:.5g} to "
        f"{high:.5g} rpm, {angle.origin}; one bin is {1 / turns[-1]:.3g} orders or {1 / read.duration:.3g} Hz"
    )


def _known_table(read: Recording, turns: np.ndarray, lines: Sequence[KinematicLine]) -> str:
    """Return a row per order that has a cause: its amplitude, and how far that is above the floor beside it."""
    torque = read.torque()
    top = 0.4 * read.sample_rate / float(np.max(np.diff(turns)) * read.sample_rate)
    spectrum = order_spectrum(over_angle(read, turns), highest=top)
    floor = floor_of(spectrum.amplitudes)
    places: dict[float, list[KinematicLine]] = {}
    for line in sorted(lines, key=lambda line: line.output_order):
        places.setdefault(float(f"{line.output_order:.9g}"), []).append(line)
    rows = [["output order", "motor order", "amplitude N*m", "above floor dB", "cause"]]
    for order, causes in places.items():
        if order > min(top, float(spectrum.places[-1])) or order * turns[-1] < 2:
            continue
        amplitude = line_amplitude(torque, turns, order)
        above = 20 * np.log10(max(amplitude, 1e-300) / floor[round(order / spectrum.width)])
        rows.append([f"{order:.6g}", f"{causes[0].motor_order:.6g}", f"{amplitude:.5f}", f"{above:.1f}",
                     cut(label_of(causes), 70)])  # fmt: skip
    return grid(rows)


def _found_table(found: Sequence[DetectedLine]) -> str:
    if not found:
        return "nothing stands out of the floor beside it"
    rows = [["stands out", "place", "amplitude N*m", "gathered by angle %", "by time %", "angle over time dB", "what"]]
    for one in found:
        unit = "order" if one.detected_over == "order" else "Hz"
        rows.append([
            {"order": "shaft", "frequency": "fixed", "either": "either"}[one.axis], f"{one.place:.6g} {unit}",
            f"{one.amplitude:.5f}", f"{100 * one.domain.by_order:.1f}", f"{100 * one.domain.by_frequency:.1f}",
            f"{one.domain.contrast_dB:+.1f}", cut(one.label or "no known cause", 60),
        ])  # fmt: skip
    return grid(rows)


def _sentences(found: Sequence[DetectedLine], kinematics: Kinematics) -> list[str]:
    told = [f"No {family.replace('_', ' ')} lines: {reason}." for family, reason in kinematics.left_out.items()]
    undecided = [one for one in found if one.axis == "either"]
    if undecided:
        told.insert(0, f"{len(undecided)} lines gather alike on both axes (within {DECIDED:g} dB): the speed changes "
                       "too little to tell the shaft from a fixed frequency; record a ramp.")  # fmt: skip
    return told


def _hertz(text: str) -> float:
    try:
        value = parse_quantity(text, "Hz")
    except UnitError as error:
        raise UnitError(f"--mains: {error}") from None
    if not value > 0:
        raise InputError(f"--mains: a grid of {text} cannot be; write for example '50 Hz'")
    return value
