"""``torquerig duty``: torque, speed and winding temperature of a motor over a duty cycle."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import click

from torquerig.catalog.motor import Motor
from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option, edited, profile_option, profile_settings, set_option
from torquerig.cli.completions import gearbox_names, motor_names
from torquerig.cli.json_option import json_option
from torquerig.errors import InputError, UnitError
from torquerig.plain_table import grid, wrapped
from torquerig.recordings.files import read_recording
from torquerig.reporting.json_results.sizing import DutyResult, duty_result
from torquerig.rig.leading_part import leading_motor
from torquerig.rig.parts import WormGear
from torquerig.scenario.checks.recorded_load import refuse_unstated_load
from torquerig.scenario.checks.requirement_check import check_requirement, entry_of
from torquerig.scenario.checks.unused import unused_by_run
from torquerig.scenario.drive_requirement import drive_requirement
from torquerig.scenario.kinematics import ratio_text
from torquerig.study.one_drive import scenario_or_candidate
from torquerig.thermal.duty_temperatures import DutyTemperatures, temperatures_of_duty
from torquerig.thermal.duty_text import duty_rows, figure_rows, verdict_sentence
from torquerig.thermal.motor_duty import MotorDuty, duty_of_recording, duty_of_requirement
from torquerig.thermal.motor_variants import ThermalVariants, thermal_variants
from torquerig.units import parse_quantity

MOST_ROWS = 24  # of the table of stretches


@dataclass(frozen=True, kw_only=True)
class _DutyOfMotor:
    """A duty cycle, its motor, a title, and the exceeded ratings."""

    duty: MotorDuty
    entry: Motor
    title: str
    flags: tuple[str, ...] = ()
    unused: tuple[str, ...] = ()


@click.command("duty")
@click.argument("scenario", type=click.Path(path_type=Path))
@click.option(
    "--motor",
    shell_complete=motor_names,
    default=None,
    help="Another motor of the catalog (or alias), tuned and limited as in the study.",
)
@click.option(
    "--gearbox",
    shell_complete=gearbox_names,
    default=None,
    help="Another gearbox of the catalog, tuned and limited as in the study.",
)
@click.option("--recording", type=click.Path(path_type=Path), default=None,
              help="Take torque and speed from a recording (with motor_torque) instead of the profile.")  # fmt: skip
@click.option("--duration", default=None, help="Length of a ramp or reversal, with its unit. Default: that of the "
              "scenario's section recording, else 10 s.")  # fmt: skip
@click.option("--ambient", type=click.FloatRange(-60, 150), default=40.0, show_default=True,
              help="Temperature of the surroundings in degrees Celsius.")  # fmt: skip
@click.option(
    "--seed",
    type=click.IntRange(0),
    default=1,
    show_default=True,
    help="Seed for values that the catalog gives as intervals.",
)
@click.option("--picture", type=click.Path(path_type=Path), default=None, help="Draw the cycle: .png or .svg.")
@click.option("--force", is_flag=True, help="Overwrite an earlier picture of that name.")
@profile_option
@set_option
@catalog_option
@json_option("duty", reads=("scenario", "recording"))
def command(
    *, scenario: Path, motor: str | None, gearbox: str | None, recording: Path | None, duration: str | None,
    ambient: float, seed: int, picture: Path | None, force: bool, profile: str | None, settings: tuple[str, ...],
    catalogs: tuple[Path, ...],
) -> DutyResult:  # fmt: skip
    """Compute torque, speed and winding temperature of SCENARIO's motor when its profile repeats without end.

    There is no simulation: speed and torque follow from inertias, loads, friction and gears. Values that the catalog
    gives as intervals stay intervals. Values that no document states are listed with the assumption.

    Example: torquerig duty scenarios/wear_rig.yaml --profile duty_cycle --picture duty.svg
    """
    if picture is not None and picture.exists() and not force:
        raise InputError(f"{picture}: is there already; choose another name, or overwrite it with --force")
    catalog = catalog_for(scenario, catalogs)
    document = edited(scenario, (*settings, *profile_settings(profile)))
    made = scenario_or_candidate(document, catalog, motor=motor, gearbox=gearbox, seed=seed)
    entry = entry_of(made.rig, catalog)
    if leading_motor(made.rig) is None:
        raise InputError(f"{scenario}: the rig has no motor, so that nothing is heated; add one with catalog: NAME")
    if entry is None:
        raise InputError(f"{scenario}: the driven motor is not in the catalog, so its thermal data are unknown; "
                         "name one with catalog: or --motor")  # fmt: skip
    if recording is not None:
        read = read_recording(recording)
        of_motor = _DutyOfMotor(
            duty=duty_of_recording(read), entry=entry, title=f"{entry.name}, {recording}, {read.duration:g} s"
        )
    else:
        refuse_unstated_load(made)
        points = made.rig.run.set_points
        seconds = made.recording.duration if duration is None else _seconds(duration)
        length = seconds if points is None else points.breakpoints(top=0.0, duration=0.0).length
        flags = check_requirement(made, catalog, duration=length)
        requirement = drive_requirement(made.rig, duration=length)
        title = f"{entry.name}, {ratio_text(made.rig)}, {made.rig.run.profile}, {length:g} s"
        of_motor = _DutyOfMotor(
            duty=duty_of_requirement(requirement),
            entry=entry,
            title=title,
            flags=flags,
            unused=unused_by_run(made),
        )
    copies = thermal_variants(entry)
    judged = temperatures_of_duty(of_motor.duty, copies, ambient=ambient)
    _print_duty(of_motor, copies, judged, ambient=ambient)
    for worm in made.rig.parts_of(WormGear):
        click.echo(wrapped(worm.losses))
    if picture is not None:
        _draw(of_motor, copies, picture, ambient=ambient, force=force)
    return duty_result(
        judged, copies, title=of_motor.title, ambient=ambient, flagged=of_motor.flags, not_used=of_motor.unused
    )


def _print_duty(of_motor: _DutyOfMotor, copies: ThermalVariants, judged: DutyTemperatures, *, ambient: float) -> None:
    click.echo(f"{of_motor.title}, repeated without end, ambient {ambient:g} °C")
    if of_motor.duty.duration.size <= MOST_ROWS:
        click.echo(grid(duty_rows(of_motor.duty, copies.nominal)) + "\n")
    click.echo(grid(figure_rows(judged, of_motor.entry)) + "\n")
    click.echo(wrapped(verdict_sentence(judged, copies)))
    for flag in of_motor.flags:
        click.echo(wrapped(f"flagged: {flag}"))
    for unused in of_motor.unused:
        click.echo(wrapped(f"stated and not used: {unused}"))
    click.echo("\nassumed, because no document states these values:")
    for name, text in copies.assumed.items():
        click.echo(wrapped(f"{name}: {text}"))


def _draw(of_motor: _DutyOfMotor, copies: ThermalVariants, path: Path, *, ambient: float, force: bool) -> None:
    from torquerig.reporting.figures.picture import write_picture
    from torquerig.reporting.sizing.duty_figure import duty_figure

    figure = duty_figure(of_motor.duty, copies, ambient=ambient, title=of_motor.title)
    write_picture(figure, path, overwrite=force)
    click.echo(f"wrote {path}")


def _seconds(duration: str) -> float:
    try:
        seconds = parse_quantity(duration, "s")
    except UnitError as error:
        raise UnitError(f"--duration: {error}") from None
    if not seconds > 0:
        raise InputError(f"--duration: {duration} must be more than 0; write for example '10 s'")
    return seconds
