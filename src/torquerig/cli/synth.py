"""``torquerig synth``: test signals from known components, and faults of samples with their truth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from torquerig.cli.common_options import quantity_in
from torquerig.cli.completions import motor_names
from torquerig.cli.json_option import json_option
from torquerig.cli.synth_fault import fault
from torquerig.errors import InputError
from torquerig.recordings.files import check_target
from torquerig.reporting.json_results.simulate import ChannelLevels, WrittenResult, named, torque_levels
from torquerig.reporting.json_results.values import Quantity

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


_seed = click.option("--seed", type=click.IntRange(0), default=None, help="Seed of all random numbers; default 1.")
_force = click.option("--force", is_flag=True, help="Overwrite earlier recordings of that name.")
_out = click.option("--out", type=click.Path(path_type=Path), default=Path("synthetic.parquet"), show_default=True,
                    help="Recording to write: .parquet, .csv, .mat or .tdms, with its sidecar.")  # fmt: skip


def _run_options(function: Callable[..., None]) -> Callable[..., None]:
    """Add the options of a recording that is described on the command line."""
    for option in (
        click.option("--ratio", type=float, default=None, help="Motor turns per output turn, for the sidecar."),
        click.option("--motor", shell_complete=motor_names, default=None,
                     help="Motor of the catalog, for the sidecar."),
        click.option("--speed", callback=quantity_in("rad/s"), default=None, metavar="SPEED",
                     help="Speed of the motor for the sidecar, such as '1000 rpm'."),
        click.option("--rate", callback=quantity_in("Hz"), default="25 kHz", show_default=True, metavar="FREQUENCY",
                     help="Sample rate."),
        click.option("--duration", callback=quantity_in("s"), default="10 s", show_default=True, metavar="TIME",
                     help="Length of the recording."),
        click.option("--amplitude", callback=quantity_in("N*m"), default="1 mN*m", show_default=True, metavar="TORQUE",
                     help="Amplitude of each sine, zero to peak."),
    ):  # fmt: skip
        function = option(function)
    return function


@click.group("synth")
def command() -> None:
    """Make test signals from known components, and recordings with known faults, to validate filters and detectors.

    The same description and seed give the same bytes.
    """


@command.command("control")
@_run_options
@_seed
@_out
@_force
@json_option("synth-control")
def control(*, seed: int | None, out: Path, force: bool, **run: Any) -> WrittenResult:
    """Make a control signal: every frequency from 0 to half the sample rate at equal amplitude.

    Example: torquerig synth control --amplitude '1 mN*m' --out control.parquet
    """
    return _write_mixture({"control": {"type": "control"}}, "control", run, seed=seed, out=out, force=force)


@command.command("sweep")
@click.option("--from", "start", callback=quantity_in("Hz"), default="1 Hz", show_default=True, metavar="FREQUENCY")
@click.option("--to", "stop", callback=quantity_in("Hz"), default="10 kHz", show_default=True, metavar="FREQUENCY")
@click.option(
    "--linear", "spacing", flag_value="linear", help="Sweep linearly in frequency instead of logarithmically."
)
@_run_options
@_seed
@_out
@_force
@json_option("synth-sweep")
def sweep(
    *, start: float, stop: float, spacing: str | None, seed: int | None, out: Path, force: bool, **run: Any
) -> WrittenResult:
    """Make a sine sweep.

    Example: torquerig synth sweep --from '1 Hz' --to '2 kHz' --out sweep.parquet
    """
    written = {"type": "sweep", "start": f"{start!r} Hz", "stop": f"{stop!r} Hz", "spacing": spacing or "logarithmic"}
    return _write_mixture({"sweep": written}, "sweep", run, seed=seed, out=out, force=force)


@command.command("mixture")
@click.argument("description", type=click.Path(path_type=Path))
@_seed
@_out
@_force
@json_option("synth-mixture", reads=("description",))
def mixture(*, description: Path, seed: int | None, out: Path, force: bool) -> WrittenResult:
    """Make the mixture of DESCRIPTION (YAML), with each component as a separate channel.

    Example: torquerig synth mixture scenarios/mixture_example.yaml --out mixture.parquet
    """
    check_target(out, overwrite=force)
    return _write(_mixed(description, seed), out, force=force)


@command.command("pair")
@click.argument("description", type=click.Path(path_type=Path))
@_seed
@_out
@_force
@json_option("synth-pair", reads=("description",))
def pair(*, description: Path, seed: int | None, out: Path, force: bool) -> WrittenResult:
    """Make the mixture of DESCRIPTION, and its load and noise as separate recordings (NAME_load, NAME_noise).

    Example: torquerig synth pair scenarios/mixture_example.yaml --out pair.parquet
    """
    from torquerig.synthetic.pairs import load_only, noise_only

    targets = [out, *(out.with_name(f"{out.stem}_{word}{out.suffix}") for word in ("load", "noise"))]
    for target in targets:
        check_target(target, overwrite=force)
    whole = _mixed(description, seed)
    each = zip((whole, load_only(whole), noise_only(whole)), targets, strict=True)
    made = [_write(recording, target, force=force) for recording, target in each]
    return WrittenResult(tuple(path for one in made for path in one.written), levels=made[0].levels, seed=made[0].seed)


command.add_command(fault)


@command.command("effects")
@click.argument("scenario", type=click.Path(path_type=Path))
@click.option("--duration", callback=quantity_in("s"), default="10 s", show_default=True, metavar="TIME")
@click.option("--set", "settings", multiple=True, metavar="PATH=VALUE", help="Change a value without editing.")
@_seed
@_out
@_force
@json_option("synth-effects", reads=("scenario",))
def effects(
    *, scenario: Path, duration: float, settings: tuple[str, ...], seed: int | None, out: Path, force: bool
) -> WrittenResult:
    """Decompose the reading of SCENARIO's rig into the contribution of each mechanism and sensor stage.

    Contributions of sensor stages are exact. Those of mechanisms on the shafts are differences between runs in which
    the mechanisms are switched on one after the other.

    Example: torquerig synth effects scenarios/wear_rig.yaml --out effects.parquet
    """
    from torquerig.catalog.search import catalog_for
    from torquerig.cli.common_options import edited
    from torquerig.plain_table import fixed, grid, rms_size
    from torquerig.scenario.reading import read_scenario
    from torquerig.synthetic.mixture import components_of
    from torquerig.synthetic.simulated import separated_contributions

    check_target(out, overwrite=force)
    number = 1 if seed is None else seed
    made = read_scenario(edited(scenario, settings), catalog_for(scenario, ()), seed=number)
    wander = made.operating_point.slow_speed_wander
    recording = separated_contributions(made.rig, duration=duration, seed=number, wander=wander, scenario=made.title)
    result = _write(recording, out, force=force)
    labels = recording.origin["components"]
    size, components = rms_size(recording.torque()), components_of(recording)
    rows = [
        [name, *(fixed(float(one), scale=size, digits=6) for one in (values.mean(), values.std())), labels[name]]
        for name, values in components.items()
    ]
    click.echo(grid([["component", "mean N*m", "std N*m", "what it is"], *rows]))
    levels = [
        ChannelLevels(name, Quantity(float(values.mean()), "N*m"), Quantity(float(values.std()), "N*m"))
        for name, values in components.items()
    ]
    return replace(result, levels=(*result.levels, *levels), texts=dict(labels))


def _mixed(description: Path, seed: int | None) -> Recording:
    from torquerig.synthetic.description import read_mixture
    from torquerig.synthetic.mixture import mixed

    made = read_mixture(description)
    return mixed(made if seed is None else made.model_copy(update={"seed": seed}))


def _write_mixture(
    components: dict[str, dict[str, str]], title: str, run: dict[str, Any], *, seed: int | None, out: Path, force: bool
) -> WrittenResult:
    """Write a mixture of one component that the command line describes."""
    from torquerig.synthetic.mixture import Mixture, mixed

    check_target(out, overwrite=force)
    for option, value in (("--amplitude", run["amplitude"]), ("--duration", run["duration"]), ("--rate", run["rate"])):
        if not value > 0:
            raise InputError(f"{option}: {value:g} is not possible; write more than 0")
    if run["ratio"] is not None and not run["ratio"] > 0:
        raise InputError(f"--ratio {run['ratio']:g} is not possible; write motor turns per output turn, more than 0")
    written = {name: {**one, "amplitude": f"{run['amplitude']!r} N*m"} for name, one in components.items()}
    described = {
        "synthetic": title, "duration": f"{run['duration']!r} s", "sample_rate": f"{run['rate']!r} Hz",
        "seed": 1 if seed is None else seed, "motor": run["motor"], "gear_ratio": run["ratio"],
        "motor_speed": None if run["speed"] is None else f"{run['speed']!r} rad/s", "components": written,
    }  # fmt: skip
    made = Mixture.model_validate(described)
    return _write(mixed(made), out, force=force)


def _write(recording: Recording, out: Path, *, force: bool) -> WrittenResult:
    from torquerig.synthetic.writing import write_synthetic

    written = write_synthetic(recording, out, overwrite=force)
    from torquerig.plain_table import fixed, rms_size

    torque = recording.torque()
    mean, spread = (fixed(float(one), scale=rms_size(torque), digits=6) for one in (torque.mean(), torque.std()))
    click.echo(
        f"wrote {' and '.join(str(path) for path in written)}: {recording.samples} samples at "
        f"{recording.sample_rate:g} Hz, mean {mean} N*m, std {spread} N*m"
    )
    return WrittenResult(named(written), levels=torque_levels(recording), seed=int(recording.origin["seed"]))
