"""``torquerig filter``: a recording through filter chains."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import click

from torquerig.catalog.reading import Catalog
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli.inputs import catalog_beside, catalog_option, winding_of
from torquerig.errors import InputError, did_you_mean
from torquerig.metrics.truth_error import TRUE_LOAD, truth_error
from torquerig.plain_table import grid
from torquerig.signals.chain import Chain
from torquerig.signals.chain_file import read_chains
from torquerig.signals.effect import FilterEffect, chain_effect
from torquerig.signals.files import check_target, read_recording, write_recording
from torquerig.signals.kinematics import Kinematics
from torquerig.signals.recording import Recording


@click.command("filter")
@click.argument("recording", type=click.Path(path_type=Path))
@click.option("--chain", "names", multiple=True, help="Chain to apply; several compare them. Default: the seed's two.")
@click.option(
    "--filters", type=click.Path(path_type=Path), default=None, help="File of chains; default: the shipped one."
)
@click.option("--motor", default=None, help="Motor of the catalog, where the sidecar does not name it.")
@click.option("--ratio", type=float, default=None, help="Motor turns per output turn, where the sidecar does not say.")
@click.option("--out", type=click.Path(path_type=Path), default=None, help="Write the filtered recording (one chain).")
@click.option("--picture", type=click.Path(path_type=Path), default=None, help="Draw the spectrum before and after.")
@click.option("--force", is_flag=True, help="Overwrite an earlier recording or picture of that name.")
@catalog_option
def command(
    *, recording: Path, names: tuple[str, ...], filters: Path | None, motor: str | None, ratio: float | None,
    out: Path | None, picture: Path | None, force: bool, catalogs: tuple[Path, ...],
) -> None:  # fmt: skip
    """Put RECORDING through filter chains and say what they changed: spread, mean, energy, and each family of lines.

    A smaller spread is no proof of less noise: any twenty notches lower it. Only a simulated recording with its truth
    tells how far the result is from the true load.
    """
    _check_targets(names, out, picture, force=force)
    before = read_recording(recording)
    kinematics = _kinematics(before, catalog_beside(None, catalogs), motor=motor, ratio=ratio)
    known = read_chains(filters or shipped_scenarios() / "filters.yaml", kinematics=kinematics)
    chains = [_chain(name, known) for name in names or ("seed_code", "seed_text")]
    results = [(chain, chain.apply(before)) for chain in chains]
    effects = [(chain, after, chain_effect(before, after, ratio=kinematics.ratio, lines=chain.lines))
               for chain, after in results]  # fmt: skip
    click.echo(f"{recording}: std {effects[0][2].std_before:.5f} N*m, mean {effects[0][2].mean_before:.5f} N*m")
    click.echo(grid([_head(before), *(_row(chain, after, effect, before) for chain, after, effect in effects)]) + "\n")
    for chain, _, effect in effects:
        _tell_families(chain, effect)
    click.echo(f"speed for energy and lines: {effects[0][2].speed_origin}")
    if out is not None:
        written = write_recording(results[0][1], out, overwrite=force)
        click.echo(f"wrote {' and '.join(str(path) for path in written)}")
    if picture is not None:
        _draw(before, results[0][1], chains[0], kinematics, picture, force=force)


def _check_targets(names: tuple[str, ...], out: Path | None, picture: Path | None, *, force: bool) -> None:
    if (out or picture) and len(names) != 1:
        raise InputError("--out and --picture take one chain; name it with --chain")
    if out is not None:
        check_target(out, overwrite=force)
    if picture is not None and picture.exists() and not force:
        raise InputError(f"{picture}: is there already; choose another name, or overwrite it with --force")


def _kinematics(before: Recording, catalog: Catalog, *, motor: str | None, ratio: float | None) -> Kinematics:
    name, turns = motor or before.run.motor, before.run.gear_ratio if ratio is None else ratio
    if name is None or turns is None:
        missing = "--motor NAME" if name is None else "--ratio N"
        raise InputError(f"{before.name}: the sidecar does not name the motor and gear_ratio of the run; add {missing}")
    pole_pairs, slots, assumed = winding_of(catalog.motor(name))
    sheet = before.run.others
    if motor is None and isinstance(sheet.get("pole_pairs"), int):
        pole_pairs, slots, assumed = sheet["pole_pairs"], sheet.get("slots"), ""
    if assumed:
        click.echo(f"assumed of {name}: {assumed}")
    return Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=turns)


def _chain(name: str, known: Mapping[str, Chain]) -> Chain:
    if name not in known:
        raise InputError(f"--chain {name}: there is no such chain; {did_you_mean(name, known)}")
    return known[name]


def _head(before: Recording) -> list[str]:
    head = ["chain", "std N*m", "std cut %", "variance cut %", "mean change %", "energy change %"]
    return [*head, "error to true load N*m"] if TRUE_LOAD in before.channels else head


def _row(chain: Chain, after: Recording, effect: FilterEffect, before: Recording) -> list[str]:
    energy = effect.energy_change_percent
    row = [
        chain.name, f"{effect.std_after:.5f}", f"{effect.std_reduction_percent:.1f}",
        f"{effect.variance_reduction_percent:.1f}", f"{effect.mean_change_percent:.4f}",
        "-" if energy is None else f"{energy:.4f}",
    ]  # fmt: skip
    return [*row, f"{truth_error(after, before):.5f}"] if TRUE_LOAD in before.channels else row


def _tell_families(chain: Chain, effect: FilterEffect) -> None:
    levels = effect.family_levels()
    if levels:
        rows = [[family, f"{was:.5f}", f"{now:.5f}"] for family, (was, now) in levels.items()]
        click.echo(grid([[f"{chain.name}: lines", "before N*m", "after N*m"], *rows]) + "\n")
    for reason in chain.left_out:
        click.echo(f"{chain.name}: left out {reason}")


def _draw(
    before: Recording, after: Recording, chain: Chain, kinematics: Kinematics, path: Path, *, force: bool
) -> None:
    from torquerig.report.picture import write_picture
    from torquerig.report.spectrum_figure import spectrum_figure

    if before.run.speed is None:
        raise InputError(f"{before.name}: the sidecar states no speed_rpm, so that no line can be placed; add it")
    lines = chain.lines or kinematics.lines()
    figure = spectrum_figure(before, after, lines=lines, motor_speed=before.run.speed, ratio=kinematics.ratio)
    write_picture(figure, path, overwrite=force)
    click.echo(f"wrote {path}")
