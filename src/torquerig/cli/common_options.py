"""Options that several commands share: catalogs, settings, profile and kept results."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from torquerig.cases.kept_folder import kept_folder, kept_limit
from torquerig.cases.kept_results import KeptResults, opened_results
from torquerig.document import Document, read_document
from torquerig.errors import InputError, UnitError, did_you_mean
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

FROM_CACHE = "torquerig.from_cache"
"""Key of a command's context: how many of its drives were kept results, for the provenance."""


def cache_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--cache FOLDER`` and ``--no-cache`` to the function of a command, as ``cache`` and ``no_cache``."""
    folder = click.option(
        "--cache", type=click.Path(path_type=Path), default=None, metavar="FOLDER",
        help="Folder of kept results. Default: TORQUERIG_CACHE, else that of the platform; see torquerig cache.",
    )  # fmt: skip
    off = click.option("--no-cache", is_flag=True, help="Read and keep no results; compute everything.")
    return folder(off(function))


@contextmanager
def kept_results(cache: Path | None, *, no_cache: bool) -> Iterator[KeptResults | None]:
    """Yield the kept results of a command; at the end, notes about their folder are written to standard error.

    Raises
    ------
    InputError
        Where both options are given, or the limit of the environment is no size.
    """
    if no_cache and cache is not None:
        raise InputError("--cache and --no-cache exclude each other; leave one of them out")
    folder = None if no_cache else kept_folder(cache)
    if folder is None:
        yield None
        return
    with opened_results(folder, limit=kept_limit()) as kept:
        try:
            yield kept
        finally:
            for note in kept.notes:
                click.echo(note, err=True)


def note_from_cache(number: int) -> None:
    """Note for the provenance of the running command how many results were kept ones."""
    context = click.get_current_context(silent=True)
    if context is not None:
        context.meta[FROM_CACHE] = context.meta.get(FROM_CACHE, 0) + number


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
    from torquerig.recordings.run import PROFILES

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
