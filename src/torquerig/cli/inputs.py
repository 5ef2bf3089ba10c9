"""What several commands are given: a scenario with its catalogs and settings."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import click

from torquerig.catalog.drawing import nominal
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.shipped import shipped_folder
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


def catalog_beside(scenario: Path | None, further: Sequence[Path]) -> Catalog:
    """Return the shipped catalog, the one beside the scenario (or beside its folder), and further folders, merged."""
    folders = [shipped_folder()]
    if scenario is not None:
        near = scenario.resolve().parent
        folders += [folder for folder in (near.parent / "catalogs", near / "catalogs") if folder.is_dir()]
    else:
        here = Path("catalogs")
        folders += [here] if here.is_dir() else []
    folders += further
    distinct = {folder.resolve(): folder for folder in reversed(folders)}
    return load_catalog(*reversed(list(distinct.values())))


def edited(scenario: Path, settings: Sequence[str]) -> Document:
    """Return the scenario's document with the ``--set`` values put in."""
    return overridden(read_document(scenario), settings)


def winding_of(motor: Motor) -> tuple[int | None, int | None, str]:
    """Return pole pairs and slots, the likeliest where they are not documented, and what was assumed in words."""
    copy = nominal(motor)
    counts = {key: copy.count(key) if key in copy.values else None for key in ("pole_pairs", "slots")}
    words = [
        f"{key.replace('_', ' ')} {count} of {copy.assumed[key].known}"
        for key, count in counts.items()
        if key in copy.assumed
    ]
    return counts["pole_pairs"], counts["slots"], ", ".join(words)
