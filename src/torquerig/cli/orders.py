"""``torquerig orders``: order lines of a motor and gearbox, and their coincidences."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.catalog.search import catalog_for
from torquerig.catalog.winding import winding_of
from torquerig.cli.common_options import catalog_option
from torquerig.errors import InputError, UnitError
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.order_report import orders_report
from torquerig.orders.kinematics.order_report_text import ORDERS_HEADER, name_of, orders_rows, orders_sentences
from torquerig.orders.kinematics.teeth import Planetary
from torquerig.plain_table import grid, wrapped
from torquerig.units import parse_quantity


@click.command("orders")
@click.option("--motor", default="bldc-12n14p", show_default=True, help="Motor of the catalog.")
@click.option("--gearbox", default=None, help="Gearbox of the catalog, for its ratio and teeth.")
@click.option(
    "--ratio", type=float, default=None, help="Motor turns per output turn; replaces the ratio of the gearbox."
)
@click.option("--sun", type=int, default=None, help="Teeth of the sun gear of a planetary stage; needs --ring.")
@click.option("--ring", type=int, default=None, help="Teeth of the ring gear.")
@click.option("--planets", type=int, default=None, help="Number of planets; determines which mesh lines cancel.")
@click.option("--speed", default="1000 rpm", show_default=True, help="Motor speed, with its unit.")
@click.option(
    "--harmonics",
    type=click.IntRange(1, 20),
    default=4,
    show_default=True,
    help="Number of harmonics of each family of lines.",
)
@click.option("--mains", default="50 Hz", show_default=True, help="Mains frequency.")
@catalog_option
def command(
    *, motor: str, gearbox: str | None, ratio: float | None, sun: int | None, ring: int | None,
    planets: int | None, speed: str, harmonics: int, mains: str, catalogs: tuple[Path, ...],
) -> None:  # fmt: skip
    """List frequency, order at motor and output shaft, cause and coincidences of each line."""
    catalog = catalog_for(None, catalogs)
    pole_pairs, slots, assumed = winding_of(catalog.motor(motor))
    teeth: tuple[Planetary, ...] = ()
    if (sun is None) != (ring is None):
        raise InputError("--sun and --ring need each other; write both, for example --sun 21 --ring 84")
    if planets is not None and sun is None:
        raise InputError("--planets needs --sun and --ring; write all three, for example 21, 84 and 3")
    if sun is not None and ring is not None:
        teeth = (Planetary(sun, ring, planets),)
    box = catalog.gearbox(gearbox) if gearbox else None
    sets = box.tooth_sets() if box else ()
    known_ratio = ratio if ratio is not None else teeth[0].ratio if teeth else box.ratio if box else 5.0
    kinematics = Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=known_ratio, teeth=teeth or sets[:1])
    report = orders_report(
        kinematics, _read(speed, "rad/s", "--speed"), harmonics=harmonics, mains=_read(mains, "Hz", "--mains")
    )
    click.echo(f"{motor}, {known_ratio:g}:1, motor at {speed}" + (f"; assumed {assumed}" if assumed else ""))
    rows = [list(row) for row in orders_rows(report)]
    place = ORDERS_HEADER.index("cause")
    click.echo(grid([list(ORDERS_HEADER[:place]), *[row[:place] for row in rows]]) + "\n")
    for line in report.lines:
        if line.harmonic == 1:
            click.echo(wrapped(f"{name_of(line)}: {line.cause} [{line.source}]"))
    click.echo()
    for sentence in orders_sentences(report):
        click.echo(wrapped(sentence))


def _read(text: str, unit: str, option: str) -> float:
    try:
        return parse_quantity(text, unit)
    except UnitError as error:
        raise UnitError(f"{option}: {error}") from None
