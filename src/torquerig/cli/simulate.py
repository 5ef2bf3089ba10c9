"""``torquerig simulate``: one rig, one recording."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.cli.inputs import catalog_beside, catalog_option, edited, set_option
from torquerig.cli.tables import grid
from torquerig.errors import InputError, UnitError
from torquerig.scenario.reading import Scenario, read_scenario
from torquerig.signals.files import write_recording
from torquerig.simulate.simulate import simulate
from torquerig.study.candidates import Candidate, scenario_of
from torquerig.study.study import open_study
from torquerig.units import parse_quantity


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
    made = _scenario(scenario, settings, catalogs, motor=motor, gearbox=gearbox, seed=seed)
    recording = simulate(
        made.rig, duration=seconds, seed=seed, wander=made.operating_point.slow_speed_wander, scenario=made.title
    )
    written = write_recording(recording if truth else recording.without_truth(), out, overwrite=force)
    torque = recording.torque()
    click.echo(f"wrote {' and '.join(str(path) for path in written)}")
    click.echo(
        f"{made.rig.run.motor} at {made.rig.run.speed_rpm:.6g} rpm, {made.rig.run.gear_ratio:g}:1, "
        f"{made.rig.run.occupancy_percent:g} % occupancy: mean {torque.mean():.4f} N*m, std {torque.std():.4f} N*m"
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
        return read_scenario(document, catalog, seed=seed)
    study = open_study(document, catalog)
    box = catalog.gearbox(gearbox or study.settings.present.gearbox)
    name = motor or study.settings.present.motor
    candidate = Candidate(motor=name, gearbox=box.name, ratio=box.ratio)
    made = scenario_of(candidate, study, seed=seed)
    top, speed = catalog.motor(name).max_speed.bounds[1], made.rig.run.speed or 0.0
    if speed > top:
        raise InputError(
            f"{name}: {box.ratio:g}:1 needs {made.rig.run.speed_rpm:.0f} rpm at this output speed; the motor "
            f"reaches at most {top * 9.549296585513721:.0f} rpm: choose a smaller ratio or output speed"
        )
    return made
