"""``torquerig modes``: natural frequencies, stability margins of the speed loop, and critical speeds of a rig."""

from __future__ import annotations

from collections.abc import Sequence
from math import log10, pi
from pathlib import Path

import click

from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option, edited, set_option
from torquerig.cli.json_option import json_option
from torquerig.cli.modes_text import modes_text, poles_text
from torquerig.errors import InputError, UnitError
from torquerig.plain_table import cut, grid, wrapped
from torquerig.reporting.json_results.modes import ModesResult, modes_result
from torquerig.rig.parts import ImposedMotion, Motor
from torquerig.rig.reading_place import effort_unit
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.condensation.beforehand import said_beforehand
from torquerig.simulation.twin.crossings import Crossing, nearest_to
from torquerig.simulation.twin.linear_twin import Twin, twin_of
from torquerig.simulation.twin.margins import Margins
from torquerig.units import parse_quantity

_IMPOSED = (
    "{0} imposes the motion: its output is clamped for this calculation, there is no control loop, and no spring "
    "torque "
    "is measured, so critical speeds have no amplitude at the sensor"
)
_NO_TORQUE = (
    "{0} reads no torque, so critical speeds have no amplitude at a sensor; name a torque sensor, coupling or gear "
    "under measured: to see them"
)
NO_SPEED_TOP = 3000 * pi / 30  # [rad/s] highest speed of the diagram for a rig without set-point


@click.command("modes")
@click.argument("scenario", type=click.Path(path_type=Path))
@click.option("--speed-max", default=None, help="Highest motor speed of the diagram, with its unit. Default: 1.5 x "
              "set-point.")  # fmt: skip
@click.option("--crossings", "rows", type=click.IntRange(1, 200), default=12, show_default=True,
              help="Number of critical speeds to print, strongest first.")  # fmt: skip
@click.option("--rate", default=None, help="Sample rate of the speed controller, with its unit. Default: that of the "
              "scenario's section recording, else 25 kHz.")  # fmt: skip
@click.option(
    "--seed",
    type=click.IntRange(0),
    default=1,
    show_default=True,
    help="Seed for values that the catalog gives as intervals.",
)
@click.option(
    "--picture", type=click.Path(path_type=Path), default=None, help="Draw Campbell and Bode diagrams: .svg or .png."
)
@click.option("--force", is_flag=True, help="Overwrite an earlier picture of that name.")
@set_option
@catalog_option
@json_option("modes", reads=("scenario",))
def command(
    *, scenario: Path, speed_max: str | None, rows: int, rate: str | None, seed: int, picture: Path | None, force: bool,
    settings: tuple[str, ...], catalogs: tuple[Path, ...],
) -> ModesResult:  # fmt: skip
    """Show the modes of SCENARIO's rig, the stability margins of its speed loop, and its critical speeds.

    At a critical speed an order line has the frequency of a mode. The rig is linearised about its operating point; the
    omitted terms are listed at the end.

    Example: torquerig modes scenarios/wear_rig.yaml --picture modes.svg
    """
    if picture is not None and picture.exists() and not force:
        raise InputError(f"{picture}: is there already; choose another name, or overwrite it with --force")
    sampled = None if rate is None else _read(rate, "Hz", "--rate")
    stated_top = None if speed_max is None else _read(speed_max, "rad/s", "--speed-max")
    if (sampled is not None and not sampled > 0) or (stated_top is not None and not stated_top > 0):
        raise InputError("--rate and --speed-max must be more than 0; write for example --speed-max '3000 rpm'")
    made = read_scenario(edited(scenario, settings), catalog_for(scenario, catalogs), seed=seed)
    twin = twin_of(made.rig, rate=sampled or made.recording.sample_rate, seed=seed)
    top = stated_top or 1.5 * abs(twin.motor_speed_rpm) * pi / 30 or NO_SPEED_TOP
    if picture is not None and not twin.reads_a_spring:
        raise InputError(f"{scenario}: {made.rig.measured} imposes the motion and no spring torque is measured, so "
                         "there is no transfer function to draw; remove --picture, or name a sensor under "
                         "measured:")  # fmt: skip
    lines = twin.order_lines(kinematics_of(made.rig).lines())
    click.echo(f"{made.title}: {_about(twin)}\n")
    click.echo(modes_text(twin))
    if said := said_beforehand(made.rig, rate=twin.rate, seed=seed):
        click.echo(wrapped(f"in a simulation, {said}") + "\n")
    if not twin.reads_a_spring:
        imposed = isinstance(made.rig.part(made.rig.measured), ImposedMotion)
        click.echo(wrapped((_IMPOSED if imposed else _NO_TORQUE).format(made.rig.measured)))
        return modes_result(twin, (), title=made.title, top_speed_rpm=top * 30 / pi, unit=effort_unit(made.rig))
    found = twin.crossings(lines, top_speed=top)
    if loops := twin.margins():
        click.echo("\n".join(wrapped(_margins(one)) for one in loops) + "\n")
        click.echo(poles_text(twin.loop_poles()))
    _print_crossings(found[:rows], len(found), top, unit=effort_unit(made.rig), turns=bool(made.rig.parts_of(Motor)))
    if nearest := nearest_to(twin.motor_speed_rpm * pi / 30, [one for one in found if one.torque is not None]):
        click.echo(wrapped(_nearest(nearest, twin.motor_speed_rpm, unit=effort_unit(made.rig))) + "\n")
    for omitted in twin.point.left_out:
        click.echo(wrapped(f"omitted: {omitted}"))
    if picture is not None:
        from torquerig.reporting.figures.modes_figure import modes_figure
        from torquerig.reporting.figures.picture import write_picture

        figure = modes_figure(twin, lines, found, top_speed=top, title=made.title)
        write_picture(figure, picture, overwrite=force)
        click.echo(f"wrote {picture}")
    return modes_result(twin, found, title=made.title, top_speed_rpm=top * 30 / pi, unit=effort_unit(made.rig))


def _read(text: str, unit: str, option: str) -> float:
    try:
        return parse_quantity(text, unit)
    except UnitError as error:
        raise UnitError(f"{option}: {error}") from None


def _about(twin: Twin) -> str:
    if not twin.reads_a_spring:
        return f"linear, {twin.lowered.leader()} held"
    words = f"linear about {twin.motor_speed_rpm:.6g} rpm of {twin.lowered.leader()}"
    point, sensor = twin.point, twin.lowered.spring_names.index(twin.rig.measured)
    words += f", {point.spring_torques[sensor]:.4g} {effort_unit(twin.rig)} in {twin.rig.measured}"
    return words + (f", {point.drive_torque:.4g} N*m from the motor" if twin.lowered.drive_names else "")


def _margins(found: Margins) -> str:
    if found.crossovers:
        first, *more = found.crossovers
        words = f"crossover {first:.4g} Hz"
        words += f" (further crossovers at {', '.join(f'{one:.4g}' for one in more)} Hz)" if more else ""
    else:
        words = "no crossover: the gain is always below 1"
    if found.phase_margin is not None:
        words += f", phase margin {found.phase_margin:.1f} degrees at {found.phase_at:.4g} Hz"
    if found.gain_margin is not None:
        words += (
            f", gain margin {found.gain_margin:.3g} ({20 * log10(found.gain_margin):.1f} dB) at {found.gain_at:.4g} Hz"
        )
    if found.lower_gain is not None:
        must = "must stay above" if found.stable else "must come down below"
        words += f", and the gain {must} {found.lower_gain:.3g} of its present value"
    words += f", modulus margin {found.modulus_margin:.3f} at {found.modulus_at:.4g} Hz"
    stability = "stable" if found.stable else "UNSTABLE: oscillation grows to the torque limit"
    return f"{found.controller}: {stability}; {words}"


def _print_crossings(shown: Sequence[Crossing], count: int, top: float, *, unit: str, turns: bool) -> None:
    if not (shown or turns):
        return
    if not shown:
        click.echo(f"no order line crosses a mode up to {top * 30 / pi:.5g} rpm\n")
        return
    rows = [
        [str(number), cut(one.line.cause, 32), f"{one.line.order:.6g}", str(one.mode), f"{one.frequency:.5g}",
         f"{one.speed_rpm:.5g}", "-" if one.torque is None else f"{one.torque:.4g}",
         f"{one.gain:.4g}" if one.line.enters.startswith("torque") else "-", f"{one.magnification:.3g}"]
        for number, one in enumerate(shown, start=1)
    ]  # fmt: skip
    head = [
        "critical speed",
        "cause",
        "motor order",
        "mode",
        "Hz",
        "motor rpm",
        f"at sensor {unit}",
        f"{unit} per N*m",
        "magnification",
    ]
    click.echo(grid([head, *rows]))
    more = f"; {count - len(shown)} weaker ones are not shown" if count > len(shown) else ""
    note = f"up to {top * 30 / pi:.5g} rpm, strongest at the sensor first{more}; - where the amplitude of the line is"
    click.echo(wrapped(f"{note} unknown, or its cause is an angle and not a torque") + "\n")


def _nearest(one: Crossing, speed_rpm: float, *, unit: str) -> str:
    away = 100 * (one.speed_rpm / abs(speed_rpm) - 1)
    return (
        f"critical speed nearest to the set-point of {speed_rpm:.5g} rpm: {one.line.cause}, order "
        f"{one.line.order:g}, crosses mode "
        f"{one.mode} at {one.speed_rpm:.5g} rpm, {abs(away):.1f} % {'above' if away >= 0 else 'below'}, with "
        f"{one.torque:.3g} {unit} at the sensor"
    )
