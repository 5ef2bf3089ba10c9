"""``torquerig simulate``: one rig, one recording."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import click

from torquerig.catalog.entry import Entry
from torquerig.cli.inputs import catalog_beside, catalog_option, edited, set_option
from torquerig.errors import InputError, UnitError, UnknownNameError
from torquerig.plain_table import grid
from torquerig.rig.parts import SpeedController
from torquerig.scenario.reading import Scenario, read_scenario
from torquerig.signals.files import check_target, write_recording
from torquerig.simulate.simulate import simulate
from torquerig.study.candidates import Candidate, scenario_of
from torquerig.study.study import open_study
from torquerig.units import parse_quantity

AnyEntry = TypeVar("AnyEntry", bound=Entry)


@click.command("simulate")
@click.argument("scenario", type=click.Path(path_type=Path))
@click.option("--motor", default=None, help="Another motor of the catalog (or alias), as the study would run it.")
@click.option("--gearbox", default=None, help="Another gearbox of the catalog, as the study would run it.")
@click.option("--duration", default="10 s", show_default=True, help="Length of the recording, with its unit.")
@click.option("--seed", type=click.IntRange(0), default=1, show_default=True, help="Fixes every random number.")
@click.option("--out", type=click.Path(path_type=Path), default=Path("simulated.parquet"), show_default=True,
              help="Recording to write: .parquet, .csv, .mat or .tdms, with its sidecar.")  # fmt: skip
@click.option("--truth", is_flag=True, help="Write the true load and the other truth channels too.")
@click.option("--force", is_flag=True, help="Overwrite an earlier recording of that name.")
@set_option
@catalog_option
def command(
    *, scenario: Path, motor: str | None, gearbox: str | None, duration: str, seed: int, out: Path, truth: bool,
    force: bool, settings: tuple[str, ...], catalogs: tuple[Path, ...],
) -> None:  # fmt: skip
    """Simulate SCENARIO and write what its torque sensor records at 25 kHz.

    The same scenario and seed give the same bytes. --motor and --gearbox take a candidate as `compare` does: with its
    speed loop tuned by the study's rule and its drive limited for the sensor.
    """
    try:
        seconds = parse_quantity(duration, "s")
    except UnitError as error:
        raise UnitError(f"--duration: {error}") from None
    check_target(out, overwrite=force)
    made = _scenario(scenario, settings, catalogs, motor=motor, gearbox=gearbox, seed=seed)
    recording = simulate(
        made.rig, duration=seconds, seed=seed, wander=made.operating_point.slow_speed_wander, scenario=made.title
    )
    written = write_recording(recording if truth else recording.without_truth(), out, overwrite=force)
    torque = recording.torque()
    click.echo(f"wrote {' and '.join(str(path) for path in written)}")
    click.echo(
        f"{made.rig.run.motor or made.title} at {made.rig.run.speed_rpm or 0.0:.6g} rpm, "
        f"{made.rig.run.gear_ratio or 1.0:g}:1, {made.rig.run.occupancy_percent or 0.0:g} % occupancy: "
        f"mean {torque.mean():.4f} N*m, std {torque.std():.4f} N*m"
    )
    if made.assumed:
        click.echo("assumed, because no document states it:")
        click.echo(grid([["value", "taken"], *([key, text] for key, text in made.assumed.items())]))


def _scenario(
    path: Path, settings: tuple[str, ...], catalogs: tuple[Path, ...], *, motor: str | None, gearbox: str | None,
    seed: int,
) -> Scenario:  # fmt: skip
    catalog = catalog_beside(path, catalogs)
    document = edited(path, settings)
    if motor is None and gearbox is None:
        made = read_scenario(document, catalog, seed=seed)
        if made.rig.parts_of(SpeedController) and made.rig.run.speed is None:
            raise InputError(
                f"{path}: operating_point states no speed; write motor_speed or output_speed, such as 200 rpm"
            )
        return made
    study = open_study(document, catalog)
    box = _asked("--gearbox", gearbox or study.settings.present.gearbox, catalog.gearbox)
    name = motor or study.settings.present.motor
    _asked("--motor", name, catalog.motor)
    candidate = Candidate(motor=name, gearbox=box.name, ratio=box.ratio)
    made = scenario_of(candidate, study, seed=seed)
    top, speed = catalog.motor(name).max_speed.bounds[1], made.rig.run.speed or 0.0
    if speed > top:
        raise InputError(
            f"{name}: {box.ratio:g}:1 needs {made.rig.run.speed_rpm:.0f} rpm at this output speed; the motor "
            f"reaches at most {top * 9.549296585513721:.0f} rpm: choose a smaller ratio or output speed"
        )
    return made


def _asked(option: str, name: str, look_up: Callable[[str], AnyEntry]) -> AnyEntry:
    try:
        return look_up(name)
    except UnknownNameError as error:
        raise UnknownNameError(f"{option} {name}: {error}") from None
