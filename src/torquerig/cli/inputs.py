"""What several commands are given: a scenario with its catalogs and settings."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import click

from torquerig.document import Document, read_document
from torquerig.errors import InputError, did_you_mean
from torquerig.recordings.run import PROFILES
from torquerig.scenario.overrides import overridden

catalog_option = click.option(
    "--catalog", "catalogs", multiple=True, type=click.Path(path_type=Path), metavar="FOLDER",
    help="A further catalog folder (motors/, gearboxes/, ...); goes before the shipped one.",
)  # fmt: skip
set_option = click.option(
    "--set", "settings", multiple=True, metavar="PATH=VALUE",
    help="Change a value without editing, for example --set load.occupancy=21 --set gearbox.ratio=10.",
)  # fmt: skip

profile_option = click.option(
    "--profile", default=None, metavar="WORD|FILE",
    help="steady, ramp, reversal or duty_cycle, or a table with time_s, speed_rpm and, if wanted, torque_Nm.",
)  # fmt: skip


def profile_settings(profile: str | None) -> tuple[str, ...]:
    """Return the settings that choose a profile by its word, or the table in a file of that name."""
    if profile is None:
        return ()
    if profile in PROFILES:
        return (f"operating_point.profile={profile}",)
    path = Path(profile)
    if not path.suffix:
        raise InputError(f"--profile {profile}: is no profile and no table file; {did_you_mean(profile, PROFILES)}")
    table = json.dumps({"file": str(path.resolve())})  # JSON is YAML
    return ("operating_point.profile=csv", f"operating_point.csv={table}")


def edited(scenario: Path, settings: Sequence[str]) -> Document:
    """Return the scenario's document with the ``--set`` values put in."""
    return overridden(read_document(scenario), settings)
