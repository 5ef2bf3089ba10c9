"""``torquerig size``: check whether motor, gearbox and sensor are large enough for the duty cycle."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.catalog.reading import Catalog
from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option, edited, profile_option, profile_settings, set_option
from torquerig.cli.completions import gearbox_names, motor_names
from torquerig.cli.json_option import json_option
from torquerig.cli.progress import drive_progress
from torquerig.document import Document
from torquerig.errors import InputError
from torquerig.metrics.sizing.drive_sizing import Sizing, sizing
from torquerig.metrics.sizing.sized_drive import SizedDrive, sized_drive
from torquerig.plain_table import grid, wrapped
from torquerig.reporting.json_results.sizing import SizeResult, all_sized, disturbance_result, sized_drive_result
from torquerig.reporting.json_results.values import Interval
from torquerig.rig.parts import WormGear
from torquerig.scenario.checks.requirement_check import check_requirement
from torquerig.scenario.kinematics import ratio_text
from torquerig.study.definition import Study, open_study
from torquerig.study.one_drive import scenario_or_candidate
from torquerig.study.ratio_sweep import RatioSweep, can_sweep, ratio_sweep
from torquerig.study.sized_candidates import with_cycle

SAMPLES = 3  # Monte Carlo samples of the drive whose disturbance is simulated


@click.command("size")
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
@click.option("--all", "every", is_flag=True, help="Size every motor x gearbox of the study, one row each.")
@click.option("--ambient", type=click.FloatRange(-60, 150), default=40.0, show_default=True,
              help="Temperature of the surroundings in degrees Celsius.")  # fmt: skip
@click.option(
    "--seed",
    type=click.IntRange(0),
    default=1,
    show_default=True,
    help="Seed for values that the catalog gives as intervals.",
)
@click.option("--picture", type=click.Path(path_type=Path), default=None,
              help="Draw operating regions, duty cycle and gear ratios: .png or .svg.")  # fmt: skip
@click.option("--shell", type=click.Path(path_type=Path), default=None,
              help="Write the sizing as an Asset Administration Shell (IDTA 02021): .aasx or .json.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite an earlier picture or shell of that name.")
@profile_option
@set_option
@catalog_option
@json_option("size", reads=("scenario",))
def command(
    *, scenario: Path, motor: str | None, gearbox: str | None, every: bool, ambient: float, seed: int,
    picture: Path | None, shell: Path | None, force: bool, profile: str | None, settings: tuple[str, ...],
    catalogs: tuple[Path, ...],
) -> SizeResult:  # fmt: skip
    """Size the drive of SCENARIO over its duty cycle, or over its profile where it states no duty cycle.

    The table has torque, speed, heat, gearbox, current and braking energy as in sizing programs. It also has the
    overload of the sensor, the disturbance before and after each filter, and the share of the load in the reading.
    Values that the catalog gives as intervals stay intervals; the catalog value that decides is listed with the result.

    Example: torquerig size scenarios/wear_rig.yaml --motor HDS6A-0104A --picture size.svg
    """
    if every and (motor or gearbox or picture or shell):
        raise InputError(
            "--all sizes every motor x gearbox of the study; remove --motor, --gearbox and --picture, and --shell"
        )
    if shell is not None:
        from torquerig.cli.size_shell import check_shell, write_sizing_shell

        check_shell(shell, overwrite=force)
    if picture is not None:
        from torquerig.reporting.figures.picture import check_picture

        check_picture(picture, overwrite=force)
    catalog = catalog_for(scenario, catalogs)
    document = edited(scenario, (*settings, *profile_settings(profile)))
    document = document if profile else with_cycle(document)
    if every:
        return _print_all(open_study(document, catalog), ambient=ambient)
    made = scenario_or_candidate(document, catalog, motor=motor, gearbox=gearbox, seed=seed)
    drive = sized_drive(made, catalog)
    flags = check_requirement(made, catalog, duration=float(drive.requirement().duration.sum()))
    study = open_study(document, catalog) if "study" in document.data else None
    sweep = ratio_sweep(drive, study) if study is not None and can_sweep(study) else None
    title = (
        f"{drive.motor_name}, {ratio_text(made.rig)}, {made.rig.run.profile}, {drive.requirement().duration.sum():g} s"
    )
    sized = _print_sizing(drive, sweep, title=title, ambient=ambient, flags=flags)
    if shell is not None:
        write_sizing_shell(shell, drive, title=title, ambient=ambient)
    disturbance: dict[str, Interval] = {}
    if study is not None:
        disturbance = _print_disturbance(study, catalog, document, motor=motor, gearbox=gearbox, seed=seed)
    if picture is not None:
        _draw(drive, sweep, picture, title=title, force=force)
    late = tuple(f"cannot follow {one}" for one in sized.late)
    return SizeResult(ambient, (sized_drive_result(title, sized),), disturbance, (*flags, *late))


def _print_sizing(
    drive: SizedDrive, sweep: RatioSweep | None, *, title: str, ambient: float, flags: tuple[str, ...]
) -> Sizing:
    from torquerig.reporting.sizing.sizing_text import sizing_rows, verdict_text

    sized = sizing(drive, ambient=ambient)
    click.echo(f"{title}, repeated without end, ambient {ambient:g} °C\n")
    click.echo(grid(sizing_rows(sized)) + "\n")
    click.echo(wrapped(verdict_text(sized)))
    for worm in drive.rig.parts_of(WormGear):
        click.echo(wrapped(worm.losses))
    for text in (*flags, *(f"cannot follow {one}" for one in sized.late)):
        click.echo(wrapped(f"flagged: {text}"))
    if sweep is not None:
        click.echo(wrapped(sweep.sentence(sized.figures["best_ratio"])))
    return sized


def _print_disturbance(
    study: Study, catalog: Catalog, document: Document, *, motor: str | None, gearbox: str | None, seed: int
) -> dict[str, Interval]:
    """Print and return the disturbance before and after each filter chain, at the set-point of the same drive."""
    from torquerig.metrics.residual_disturbance import simulated_reading_pair
    from torquerig.reporting.sizing.sizing_text import disturbance_rows
    from torquerig.scenario.overrides import overridden
    from torquerig.study.planned_drive import settling_of

    steady = overridden(document, ("operating_point.profile=steady",))
    before: list[float] = []
    after: dict[str, list[float]] = {}
    for one in range(SAMPLES):
        made = scenario_or_candidate(steady, catalog, motor=motor, gearbox=gearbox, seed=seed + one)
        if made.rig.run.speed is None:
            return {}
        wander = made.operating_point.slow_speed_wander
        both = simulated_reading_pair(
            made.rig, duration=6.0, seed=seed, wander=wander, settling=settling_of(study.settings.speed_loop),
            sample_rate=made.recording.sample_rate, phase_seed=seed + one if one else None,
        )  # fmt: skip
        before.append(both.before)
        for name, chain in study.chains(made).items():
            after.setdefault(name, []).append(both.residual_rms(chain))
    click.echo(
        f"\nDisturbance at the sensor, rms, simulated at steady speed; median and extremes of {SAMPLES} Monte Carlo "
        "samples of the catalog under the same load:"
    )
    click.echo(grid(disturbance_rows(before, after, unit=study.effort_unit)))
    return disturbance_result(before, after, unit=study.effort_unit)


def _print_all(study: Study, *, ambient: float) -> SizeResult:
    from torquerig.reporting.sizing.sizing_text import IN_TABLE, all_text
    from torquerig.study.candidate import Candidate
    from torquerig.study.candidates import candidates
    from torquerig.study.sized_candidates import sized_candidate

    found: dict[Candidate, Sizing | str] = {}
    every = list(candidates(study))
    with drive_progress("sizing") as progress:
        for one in every:
            drive = sized_candidate(one, study)
            needed, most = drive.requirement().top_speed, drive.motor.max_speed.bounds[1]
            if needed > most:
                found[one] = f"needs {needed * 9.5493:.0f} rpm, reaches at most {most * 9.5493:.0f} rpm"
            else:
                found[one] = sizing(drive, ambient=ambient, names=IN_TABLE)
            progress(len(found), len(every), one.name)
    click.echo(all_text(found))
    return SizeResult(ambient, all_sized(found), {}, ())


def _draw(drive: SizedDrive, sweep: RatioSweep | None, path: Path, *, title: str, force: bool) -> None:
    from torquerig.reporting.figures.picture import write_picture
    from torquerig.reporting.sizing.speed_torque_figure import sizing_figure

    write_picture(sizing_figure(drive, sweep, title=title), path, overwrite=force)
    click.echo(f"wrote {path}")
