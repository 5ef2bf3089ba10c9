"""``torquerig synth fault``: a recording with a known fault of its samples."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np

from torquerig.cli.common_options import quantity_in
from torquerig.cli.completions import fault_names
from torquerig.cli.json_option import json_option
from torquerig.errors import InputError
from torquerig.plain_table import grid, wrapped
from torquerig.recordings.files import check_target, read_recording
from torquerig.reporting.json_results.simulate import WrittenResult, named, torque_levels

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording
    from torquerig.synthetic.faults.drawn_fault import DrawnFault


def _list(context: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted:
        click.echo("\n\n".join(_all_faults()))
        context.exit()


@click.command("fault")
@click.argument("fault", shell_complete=fault_names)
@click.option("--list", is_flag=True, is_eager=True, expose_value=False, callback=_list,
              help="List all faults with their parameters, and which command names them.")  # fmt: skip
@click.option("--from", "source", type=click.Path(path_type=Path), default=None, metavar="RECORDING",
              help="Recording that is disturbed. Default: a drawn one with a load, order lines and noise.")  # fmt: skip
@click.option("--set", "settings", multiple=True, metavar="PARAMETER=VALUE", help="Change a parameter of the fault.")
@click.option("--duration", callback=quantity_in("s"), default=None, metavar="TIME",
              help="Length of the drawn recording. Default: 12 s.")  # fmt: skip
@click.option("--rate", callback=quantity_in("Hz"), default=None, metavar="FREQUENCY",
              help="Sample rate of the drawn recording. Default: 5 kHz.")  # fmt: skip
@click.option("--seed", type=click.IntRange(0), default=None, help="Seed of all random numbers; default 1.")
@click.option("--out", type=click.Path(path_type=Path), default=Path("synthetic.parquet"), show_default=True,
              help="Recording to write: .parquet, .csv, .mat or .tdms, with its sidecar.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite earlier recordings of that name.")
@json_option("synth-fault", reads=("source",))
def fault(
    *, fault: str, source: Path | None, settings: tuple[str, ...], duration: float | None, rate: float | None,
    seed: int | None, out: Path, force: bool,
) -> WrittenResult:  # fmt: skip
    """Draw FAULT, the name of one or a YAML file of several, into a recording, with the truth as channels.

    The channels undisturbed_NAME hold the signal without the fault, affected_by_FAULT is 1 for the samples that it
    affects. The same description and seed give the same bytes.

    Example: torquerig synth fault dropouts --set length='4 ms' --from run1.csv --out lost.parquet
    """
    from torquerig.synthetic.faults.measured import STAMPS
    from torquerig.synthetic.faults.registry import with_faults
    from torquerig.synthetic.writing import write_synthetic

    base = _base(source, duration=duration, rate=rate, seed=seed)
    check_target(out, overwrite=force, inputs=() if source is None else (source,))
    faults = _faults(fault, settings, in_a_line=base.channels[base.torque_name()].quantity == "force")
    made = with_faults(base, faults, seed=1 if seed is None else seed)
    written = write_synthetic(made, out, overwrite=force)
    click.echo(
        f"wrote {' and '.join(str(path) for path in written)}: {made.samples} samples at {made.sample_rate:g} Hz"
    )
    if STAMPS in made.channels and out.suffix.lower() != ".csv":
        click.echo(f"{out} has no column of times; write to .csv for one")
    notes = tuple(_what_changed(made, faults))
    for sentence in notes:
        click.echo(wrapped(sentence))
    return WrittenResult(named(written), notes, torque_levels(made), seed=1 if seed is None else seed)


def _is_file(fault: str) -> bool:
    return Path(fault).suffix.lower() in (".yaml", ".yml")


def _base(source: Path | None, *, duration: float | None, rate: float | None, seed: int | None) -> Recording:
    from torquerig.synthetic.base_signal import base_signal
    from torquerig.synthetic.mixture import mixed

    if source is not None:
        if duration is not None or rate is not None:
            raise InputError(f"--from {source}: has its own length and rate; remove --duration and --rate")
        return read_recording(source)
    for option, value in (("--duration", duration), ("--rate", rate)):
        if value is not None and not value > 0:
            raise InputError(f"{option}: {value:g} is not possible; write more than 0")
    return mixed(base_signal(duration=duration or 12.0, sample_rate=rate or 5_000.0, seed=1 if seed is None else seed))


def _faults(fault: str, settings: Sequence[str], *, in_a_line: bool) -> tuple[DrawnFault, ...]:
    from torquerig.synthetic.description import named_fault, read_faults

    if not _is_file(fault):
        return (named_fault(fault, settings, in_a_line=in_a_line),)
    if settings:
        raise InputError(f"--set {settings[0]}: {fault} states the parameters of its faults; change them there")
    return read_faults(Path(fault), in_a_line=in_a_line)


def _what_changed(made: Recording, faults: Sequence[DrawnFault]) -> Iterator[str]:
    from torquerig.synthetic.faults.drawn_fault import AFFECTED

    for name, mark in made.channels.items():
        if name.startswith(AFFECTED):
            yield f"{name}: {np.count_nonzero(mark.values)} of {made.samples} samples"
    truth = made.channels[f"undisturbed_{made.torque_name()}"].in_si()
    largest, spread = float(np.abs(made.torque() - truth).max()), float(truth.std())
    unit = "N" if made.channels[made.torque_name()].quantity == "force" else "N*m"
    of = f", {largest / spread:.3g} of its standard deviations" if largest and spread else ""
    yield f"the torque is up to {largest:.3g} {unit} off the undisturbed one{of}"
    for one in faults:
        yield f"{one.type}: {_who_names(type(one))}"


def _who_names(one: type[DrawnFault]) -> str:
    return (
        f"named by {', '.join(one.named_by)} from a size on" if one.named_by else f"no command names it: {one.unnamed}"
    )


def _all_faults() -> Iterator[str]:
    """Yield a text for each fault: what it is, its parameters with their defaults, and which command names it."""
    from torquerig.synthetic.faults.parameter_table import parameter_rows
    from torquerig.synthetic.faults.registry import BY_NAME

    for name, one in BY_NAME.items():
        about = wrapped(f"{name}: {(one.__doc__ or '').partition(chr(10))[0]}")
        yield "\n".join([about, grid([["parameter", "default", "meaning"], *parameter_rows(one)]), _who_names(one)])
