"""Options that several commands share: catalogs, settings and profile."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path

import click

from torquerig.document import Document, read_document
from torquerig.errors import InputError, UnitError, did_you_mean
from torquerig.recordings.run import PROFILES
from torquerig.scenario.overrides import overridden
from torquerig.units import parse_quantity

catalog_option = click.option(
    "--catalog", "catalogs", multiple=True, type=click.Path(path_type=Path), metavar="FOLDER",
    help="Further catalog folder (motors/, gearboxes/, ...); takes precedence over the shipped one.",
)  # fmt: skip
set_option = click.option(
    "--set", "settings", multiple=True, metavar="PATH=VALUE",
    help="Change a value of the scenario, for example --set load.occupancy=21 --set gearbox.ratio=10.",
)  # fmt: skip

channel_option = click.option(
    "--channel", default=None, metavar="NAME",
    help="Channel with the measured torque, where several have one and the sidecar states none as compared.",
)  # fmt: skip

profile_option = click.option(
    "--profile", default=None, metavar="WORD|FILE",
    help="steady, ramp, reversal or duty_cycle, or a table file with time_s, speed_rpm and optionally torque_Nm.",
)  # fmt: skip


def quantity_in(unit: str) -> Callable[[click.Context, click.Parameter, str | None], float | None]:
    """Return a callback of an option that converts its value with a unit to SI."""

    def converted(_: click.Context, option: click.Parameter, value: str | None) -> float | None:
        try:
            return None if value is None else parse_quantity(value, unit)
        except UnitError as error:
            raise UnitError(f"{option.opts[0]}: {error}") from None

    return converted


def profile_settings(profile: str | None) -> tuple[str, ...]:
    """Return the settings that select a profile by name, or the table of a file."""
    if profile is None:
        return ()
    if profile in PROFILES:
        return (f"operating_point.profile={profile}",)
    path = Path(profile)
    if not path.suffix:
        raise InputError(
            f"--profile {profile}: is neither a profile nor a table file; {did_you_mean(profile, PROFILES)}"
        )
    table = json.dumps({"file": str(path.resolve())})  # JSON is YAML
    return ("operating_point.profile=csv", f"operating_point.csv={table}")


def edited(scenario: Path, settings: Sequence[str]) -> Document:
    """Return the document of the scenario with the ``--set`` values."""
    return overridden(read_document(scenario), settings)
