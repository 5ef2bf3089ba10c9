"""``torquerig orders``: order lines of a motor and gearbox, and their coincidences."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from pathlib import Path

import click

from torquerig.catalog.search import catalog_for
from torquerig.catalog.winding import winding_of
from torquerig.cli.common_options import catalog_option
from torquerig.cli.completions import gearbox_names, motor_names
from torquerig.cli.json_option import json_option
from torquerig.document import read_document
from torquerig.errors import InputError, UnitError
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.order_report import orders_report
from torquerig.orders.kinematics.order_report_text import ORDERS_HEADER, name_of, orders_rows, orders_sentences
from torquerig.orders.kinematics.teeth import Planetary
from torquerig.plain_table import grid, wrapped
from torquerig.reporting.json_results.orders import OrdersResult, orders_result
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.reading import read_scenario
from torquerig.units import parse_quantity

DEFAULT_MOTOR, DEFAULT_SPEED = "bldc-12n14p", "1000 rpm"


@click.command("orders")
@click.option("--motor", shell_complete=motor_names, default=None, help="Motor of the catalog. Default: bldc-12n14p.")
@click.option(
    "--gearbox", shell_complete=gearbox_names, default=None, help="Gearbox of the catalog, for its ratio and teeth."
)
@click.option(
    "--ratio", type=float, default=None, help="Motor turns per output turn; replaces the ratio of the gearbox."
)
@click.option("--sun", type=int, default=None, help="Teeth of the sun gear of a planetary stage; needs --ring.")
@click.option("--ring", type=int, default=None, help="Teeth of the ring gear.")
@click.option("--planets", type=int, default=None, help="Number of planets; determines which mesh lines cancel.")
@click.option(
    "--scenario",
    type=click.Path(path_type=Path),
    default=None,
    help="Scenario of a rig, for the lines of all its shafts; instead of motor, gearbox and teeth.",
)
@click.option(
    "--speed", default=None, help="Motor speed, with its unit. Default: the scenario's set-point, else 1000 rpm."
)
@click.option(
    "--harmonics",
    type=click.IntRange(1, 20),
    default=4,
    show_default=True,
    help="Number of harmonics of each family of lines.",
)
@click.option("--mains", default="50 Hz", show_default=True, help="Mains frequency.")
@catalog_option
@json_option("orders", reads=("scenario",))
def command(
    *, motor: str | None, gearbox: str | None, ratio: float | None, sun: int | None, ring: int | None,
    planets: int | None, scenario: Path | None, speed: str | None, harmonics: int, mains: str,
    catalogs: tuple[Path, ...],
) -> OrdersResult:  # fmt: skip
    """List frequency, order at motor and output shaft, cause and coincidences of each line.

    Example: torquerig orders --motor bldc-12n14p --ratio 5 --speed '1000 rpm'
    """
    drive = {"motor": motor, "gearbox": gearbox, "ratio": ratio, "sun": sun, "ring": ring, "planets": planets}
    named = [f"--{option}" for option, value in drive.items() if value is not None]
    set_point = None
    if scenario is None:
        kinematics, about = _of_catalog(
            motor or DEFAULT_MOTOR, gearbox, ratio, _planetary(sun, ring, planets), catalogs
        )
    elif named:
        raise InputError(f"--scenario states motor and gears; remove {', '.join(named)}")
    else:
        kinematics, about, set_point = _of_scenario(scenario, catalogs)
    if scenario is not None and not set_point and speed is None:
        raise InputError(f"{scenario}: states no set-point of the speed; write --speed, such as --speed '1000 rpm'")
    written = speed or (f"{set_point * 30 / pi:.6g} rpm" if set_point else DEFAULT_SPEED)
    turning = _read(written, "rad/s", "--speed")
    report = orders_report(kinematics, turning, harmonics=harmonics, mains=_read(mains, "Hz", "--mains"))
    click.echo(wrapped(about.format(speed=written)))
    if kinematics.shafts:
        click.echo(_shaft_table(kinematics, turning) + "\n")
    rows = [list(row) for row in orders_rows(report)]
    place = ORDERS_HEADER.index("cause")
    click.echo(grid([list(ORDERS_HEADER[:place]), *[row[:place] for row in rows]]) + "\n")
    for line in report.lines:
        if line.harmonic == 1:
            click.echo(wrapped(f"{name_of(line)}: {line.cause} [{line.source}]"))
    click.echo()
    for sentence in orders_sentences(report):
        click.echo(wrapped(sentence))
    return orders_result(report, title=about.format(speed=written))


def _planetary(sun: int | None, ring: int | None, planets: int | None) -> tuple[Planetary, ...]:
    if (sun is None) != (ring is None):
        raise InputError("--sun and --ring need each other; write both, for example --sun 21 --ring 84")
    if planets is not None and sun is None:
        raise InputError("--planets needs --sun and --ring; write all three, for example 21, 84 and 3")
    return () if sun is None or ring is None else (Planetary(sun, ring, planets),)


def _of_catalog(
    motor: str, gearbox: str | None, ratio: float | None, teeth: tuple[Planetary, ...], catalogs: Sequence[Path]
) -> tuple[Kinematics, str]:
    """Return the kinematics of a motor and gearbox, and the head of the table."""
    catalog = catalog_for(None, catalogs)
    pole_pairs, slots, assumed = winding_of(catalog.motor(motor))
    box = catalog.gearbox(gearbox) if gearbox else None
    sets = box.tooth_sets() if box else ()
    known_ratio = ratio if ratio is not None else teeth[0].ratio if teeth else box.ratio if box else 5.0
    kinematics = Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=known_ratio, teeth=teeth or sets[:1])
    said = [f"assumed {assumed}"] if assumed else []
    if len(sets) > 1 and not teeth:
        said.append(f"assumed {sets[0].spoken}, one of {len(sets)} possible sets of {gearbox}")
    return kinematics, "; ".join((f"{motor}, {known_ratio:g}:1, motor at {{speed}}", *said))


def _of_scenario(scenario: Path, catalogs: Sequence[Path]) -> tuple[Kinematics, str, float | None]:
    """Return the kinematics of the rig of a scenario, the head of the table, and its set-point of speed [rad/s]."""
    made = read_scenario(read_document(scenario), catalog_for(scenario, catalogs), seed=1)
    kinematics = kinematics_of(made.rig)
    counted = ("pole_pairs", "slots", "teeth")
    drawn = [f"{name}: {text}" for name, text in made.assumed.items() if name.endswith(counted)]
    head = f"{made.title}, {kinematics.ratio:g}:1, {kinematics.input_name} at {{speed}}"
    return kinematics, "; ".join((head, *(f"assumed {text}" for text in drawn))), made.rig.run.speed


def _shaft_table(kinematics: Kinematics, speed: float) -> str:
    """Return one row per shaft: its turns, its speed, the parts on it."""
    rows = [["shaft", f"{kinematics.input_name} turns per turn", "rpm", "1/rev in Hz", "parts"]]
    for shaft in kinematics.shafts:
        turns = abs(speed) / shaft.ratio
        rows.append([
            shaft.name, f"{shaft.ratio:.6g}", f"{turns * 30 / pi:.6g}", f"{turns / (2 * pi):.4g}",
            ", ".join(shaft.parts),
        ])  # fmt: skip
    return grid(rows)


def _read(text: str, unit: str, option: str) -> float:
    try:
        return parse_quantity(text, unit)
    except UnitError as error:
        raise UnitError(f"{option}: {error}") from None
