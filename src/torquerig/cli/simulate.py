"""``torquerig simulate``: simulate one rig and write the recording of its sensor."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.api.simulated import default_length, sample_rate_of, under_inputs
from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import (
    catalog_option,
    edited,
    profile_option,
    profile_settings,
    quantity_in,
    set_option,
)
from torquerig.cli.completions import gearbox_names, motor_names
from torquerig.cli.json_option import json_option
from torquerig.errors import InputError, UnitError
from torquerig.plain_table import fixed, grid, rms_size, wrapped
from torquerig.recordings.files import check_target, read_recording, write_recording
from torquerig.recordings.recording import Recording
from torquerig.reporting.json_results.simulate import SimulateResult, levels_of, named
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import WormGear
from torquerig.rig.parts.gear_stage import gear_stages
from torquerig.scenario.checks.requirement_check import check_requirement
from torquerig.scenario.checks.unused import unused_by_simulation
from torquerig.scenario.kinematics import ratio_text
from torquerig.scenario.model import Scenario
from torquerig.simulation.input_channels import with_input_channels
from torquerig.simulation.loop_stability import loop_warning
from torquerig.simulation.measured_places import channel_name, what_is_read
from torquerig.simulation.simulator import simulate
from torquerig.simulation.true_lines import with_true_lines
from torquerig.study.one_drive import scenario_or_candidate
from torquerig.units import parse_quantity


@click.command("simulate")
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
@click.option("--duration", default=None,
              help="Length of the recording, with its unit. Default: that of the profile table, else of "
                   "the scenario's section recording, else 10 s.")  # fmt: skip
@click.option(
    "--rate",
    default=None,
    callback=quantity_in("Hz"),
    help="Sample rate, with its unit. Default: that of the scenario's section recording, else 25 kHz.",
)
@click.option("--seed", type=click.IntRange(0), default=1, show_default=True, help="Seed of all random numbers.")
@click.option("--out", type=click.Path(path_type=Path), default=Path("simulated.parquet"), show_default=True,
              help="Recording to write: .parquet, .csv, .mat or .tdms, with its sidecar.")  # fmt: skip
@click.option(
    "--truth", is_flag=True, help="Also write the truth channels: the true load, the torque of each line, and others."
)
@click.option("--inputs", type=click.Path(path_type=Path), default=None, metavar="RECORDING",
              help="Recording whose channels drive the parts with from: channel; its length is simulated.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite an earlier recording of that name.")
@click.option("--steps", type=click.IntRange(1), default=None, help="Integration steps a sample, taken unchecked. "
              "Default: chosen from the fastest motion, and checked.")  # fmt: skip
@click.option("--prove-step", is_flag=True, help="Run again with half the integration step and show the difference.")
@profile_option
@set_option
@catalog_option
@json_option("simulate", reads=("scenario", "inputs"))
def command(
    *, scenario: Path, motor: str | None, gearbox: str | None, duration: str | None, rate: float | None, seed: int,
    out: Path, truth: bool, inputs: Path | None, force: bool, steps: int | None, prove_step: bool, profile: str | None,
    settings: tuple[str, ...], catalogs: tuple[Path, ...],
) -> SimulateResult:  # fmt: skip
    """Simulate SCENARIO and write the recording of its sensors.

    The same scenario and seed give the same bytes. With --motor or --gearbox the speed loop is tuned by the study's
    rule, and the drive is limited to the range of the sensor, as in `torquerig compare`.

    Example: torquerig simulate scenarios/wear_rig.yaml --duration '12 s' --seed 3 --out run3.parquet
    """
    stated = _seconds(duration)
    check_target(out, overwrite=force, inputs=[] if inputs is None else [inputs])
    catalog = catalog_for(scenario, catalogs)
    document = edited(scenario, (*settings, *profile_settings(profile)))
    made = scenario_or_candidate(document, catalog, motor=motor, gearbox=gearbox, seed=seed)
    made = made if inputs is None else under_inputs(made, read_recording(inputs))
    seconds = stated or default_length(made)
    flags = check_requirement(made, catalog, duration=seconds)
    wander = made.operating_point.slow_speed_wander
    sample_rate, settling = _rate(rate) or sample_rate_of(made), made.recording.settling
    recording = simulate(
        made.rig, duration=seconds, seed=seed, sample_rate=sample_rate, wander=wander, settling=settling,
        scenario=made.title, substeps=steps,
    )  # fmt: skip
    recording = with_input_channels(recording, made.rig)
    kept = (
        with_true_lines(recording, made.rig, seed=seed, wander=wander, settling=settling)
        if truth
        else recording.without_truth()
    )
    written = write_recording(kept, out, overwrite=force)
    click.echo(f"wrote {' and '.join(str(path) for path in written)}")
    click.echo(f"{made.rig.run.motor or made.title}{_conditions(made)}: {_levels(recording, made.rig)}")
    for worm in made.rig.parts_of(WormGear):
        click.echo(wrapped(worm.losses))
    doubts = [*recording.origin.get("warnings", ()), loop_warning(made.rig, rate=sample_rate)]
    result = SimulateResult(
        title=made.title, duration_s=seconds, sample_rate_Hz=sample_rate, warnings=tuple(filter(None, doubts)),
        levels=levels_of(recording, {channel_name(made.rig, one): what_is_read(made.rig, one)[2]
                                     for one in made.rig.places}),
        flagged=tuple(flags), not_used=tuple(unused_by_simulation(made)),
        notes=(*([recording.origin["condensed"]] if "condensed" in recording.origin else []),
               *([_proof(made, duration=seconds, seed=seed, sample_rate=sample_rate)] if prove_step else [])),
        assumed=dict(made.assumed), kept=dict(made.kept), written=named(written),
    )  # fmt: skip
    _print_notes(result)
    return result


def _print_notes(made: SimulateResult) -> None:
    """Print what is doubtful, flagged, not used and assumed."""
    for doubt in made.warnings:
        click.echo(wrapped(f"warning: {doubt}"))
    for note in made.notes:
        click.echo(wrapped(note))
    for flag in made.flagged:
        click.echo(wrapped(f"flagged: {flag}"))
    for unused in made.not_used:
        click.echo(wrapped(f"stated and not used: {unused}"))
    if made.assumed:
        click.echo("assumed, because no document states these values:")
        click.echo(grid([["value", "taken"], *([key, text] for key, text in made.assumed.items())]))
    if made.kept:
        click.echo("uncertain in the scenario, simulated at the stated value:")
        click.echo(grid([["value", "stated"], *([key, text] for key, text in made.kept.items())]))


def _levels(recording: Recording, rig: Rig) -> str:
    """Return mean and standard deviation of what is measured, of several places each with its channel."""
    said = []
    for place in rig.places:
        name = channel_name(rig, place)
        read, (_, _, unit) = recording.channels[name].in_si(), what_is_read(rig, place)
        mean, spread = (fixed(float(one), scale=rms_size(read), digits=5) for one in (read.mean(), read.std()))
        of = f"{name} of {place}: " if rig.also_measured else ""
        said.append(f"{of}mean {mean} {unit}, std {spread} {unit}")
    return "; ".join(said)


def _proof(made: Scenario, *, duration: float, seed: int, sample_rate: float) -> str:
    """Return one sentence: what determined the integration step and the effect of half the step."""
    from torquerig.simulation.step_proof import prove_step

    wander = made.operating_point.slow_speed_wander
    proof = prove_step(
        made.rig, duration=duration, seed=seed, sample_rate=sample_rate, wander=wander,
        settling=made.recording.settling,
    )  # fmt: skip
    return proof.sentence()


def _conditions(made: Scenario) -> str:
    """Return set-point, ratio and occupancy of the run, each where the rig has it."""
    run = made.rig.run
    has_bed = any(hasattr(part, "mean_by_occupancy_percent") for part in made.rig.parts)
    said = [f"{run.speed_rpm:.6g} rpm"] if run.speed_rpm is not None else ["a recorded motion or torque"]
    said += [ratio_text(made.rig)] if gear_stages(made.rig) else []
    said += [f"{run.occupancy_percent or 0.0:g} % occupancy"] if has_bed else []
    return f" at {', '.join(said)}"


def _rate(stated: float | None) -> float | None:
    if stated is not None and not stated > 0:
        raise InputError(f"--rate {stated:g} Hz: a sample rate is more than 0; write for example --rate '10 kHz'")
    return stated


def _seconds(duration: str | None) -> float | None:
    try:
        return None if duration is None else parse_quantity(duration, "s")
    except UnitError as error:
        raise UnitError(f"--duration: {error}") from None
