"""``torquerig cache``: show or clear the results that are kept between calls."""

from __future__ import annotations

import re
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Literal

import click

from torquerig.cases.kept_folder import FOLDER, LARGEST, kept_folder, kept_limit, size_text
from torquerig.cases.kept_results import KeptEntry, KeptResults
from torquerig.cli.json_option import json_option
from torquerig.errors import InputError, UnitError
from torquerig.reporting.json_results.cache import CacheResult
from torquerig.reporting.json_results.values import Missing
from torquerig.units import parse_quantity

DAY = 86_400.0  # s
EMPTY = Missing("no result is kept")


@click.command("cache")
@click.argument("action", type=click.Choice(["show", "clear"]), default="show")
@click.option("--older-than", default=None, metavar="TIME",
              help="Clear only what was not used for so long, with its unit, such as '30 d' or '12 h'.")  # fmt: skip
@click.option("--cache", "stated", type=click.Path(path_type=Path), default=None, metavar="FOLDER",
              help="Folder of kept results. Default: TORQUERIG_CACHE, else that of the platform.")  # fmt: skip
@json_option("cache")
def command(*, action: Literal["show", "clear"], older_than: str | None, stated: Path | None) -> CacheResult:
    """Show the results that are kept between calls: folder, number, size, age and limit; or clear them.

    compare keeps each simulated drive and picture under all that it depends on. Results are the same with and without.
    The folder is that of --cache, of TORQUERIG_CACHE (none: nothing is kept), or the platform's. When it reaches its
    limit, 2 GiB or TORQUERIG_CACHE_LIMIT, the results that were used longest ago are removed.

    Example: torquerig cache clear --older-than '30 d'
    """
    if older_than is not None and action != "clear":
        raise InputError("--older-than is for clear; write: torquerig cache clear --older-than TIME")
    folder = kept_folder(stated)
    if folder is None:
        raise InputError(f"{FOLDER}=none: no results are kept; name a folder with --cache")
    kept = KeptResults(folder, kept_limit())
    removed, freed = kept.clear(unused_for=_seconds(older_than)) if action == "clear" else (0, 0)
    listed = list(kept.entries())
    if action == "clear":
        click.echo(f"removed {removed} results, {size_text(freed)}")
    click.echo("\n".join(_lines(kept, listed)))
    return _result(kept, listed, removed, freed)


def _lines(kept: KeptResults, listed: Sequence[KeptEntry]) -> list[str]:
    size = sum(one.size for one in listed)
    lines = [
        f"folder   {kept.folder}",
        f"results  {len(listed)}",
        f"size     {size_text(size)} of {size_text(kept.limit)} ({LARGEST} sets the limit)",
    ]
    if listed:
        newest, oldest = _ages(listed)
        lines.append(f"used     {_age_text(newest)} to {_age_text(oldest)} ago")
    return lines


def _ages(listed: Sequence[KeptEntry]) -> tuple[float, float]:
    """Return the times since the last use [s], the shortest and the longest."""
    now, used = time.time(), [one.used for one in listed]
    return max(0.0, now - max(used)), max(0.0, now - min(used))


def _age_text(seconds: float) -> str:
    for unit, length in (("days", DAY), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2 * length:
            return f"{seconds / length:.0f} {unit}"
    return f"{seconds:.0f} s"


def _result(kept: KeptResults, listed: Sequence[KeptEntry], removed: int, freed: int) -> CacheResult:
    newest, oldest = _ages(listed) if listed else (0.0, 0.0)
    return CacheResult(
        folder=str(kept.folder), entries=len(listed), bytes=sum(one.size for one in listed), limit_bytes=kept.limit,
        oldest_days=round(oldest / DAY, 3) if listed else EMPTY,
        newest_days=round(newest / DAY, 3) if listed else EMPTY, removed_entries=removed, removed_bytes=freed,
    )  # fmt: skip


def _seconds(text: str | None) -> float:
    days = re.fullmatch(r"\s*(\d+(?:\.\d+)?)\s*(?:d|day|days)\s*", text or "")
    try:
        found = 0.0 if text is None else DAY * float(days[1]) if days else parse_quantity(text, "s")
    except UnitError as error:
        raise UnitError(f"--older-than: {error}") from None
    if found < 0:
        raise InputError(f"--older-than {text}: is below 0; write a time such as '30 d'")
    return found
