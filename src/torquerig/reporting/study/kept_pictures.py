"""The pictures of a study's page: kept ones of an earlier page, or drawn now.

A picture is kept under the digests of the drives that it shows, and of what else it shows. What draws is imported only
where something is drawn.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import TYPE_CHECKING, TypeVar

from torquerig.cases.kept_values import kept_or_made

if TYPE_CHECKING:
    from collections.abc import Callable

    from torquerig.reporting.figures.page_picture import Picture
    from torquerig.reporting.layout import Table
    from torquerig.study.results import DriveResult, StudyRuns

Drawn = TypeVar("Drawn")
CLASSES = frozenset({
    "markupsafe:Markup", "torquerig.reporting.figures.page_picture:Picture", "torquerig.reporting.layout:Cell",
    "torquerig.reporting.layout:Table",
})  # fmt: skip
"""What pictures, and the table of the report's filter, are made of."""
MOST_SAMPLES = 500_000  # of the second recording of the page, which stays below 10 MB; longer ones have a fixed picture


def error_picture(runs: StudyRuns, *, present: str) -> Picture | None:
    """Return the dots of the reading errors; None where nothing was simulated."""

    def draw() -> Picture | None:
        from torquerig.reporting.study import pictures

        return pictures.error_picture(runs, present=present)

    return _kept(runs, "errors", (list(runs.row_keys.items()), present), draw)


def shares_picture(runs: StudyRuns) -> Picture | None:
    """Return the stacked bars of the shares; None where nothing was simulated."""

    def draw() -> Picture | None:
        from torquerig.reporting.study import pictures

        return pictures.shares_picture(runs)

    return _kept(runs, "shares", list(runs.row_keys.items()), draw)


def first_picture(drive: DriveResult, chain: str, runs: StudyRuns) -> Picture | None:
    """Return the picture of the first screen; None where the drive was not simulated."""

    def draw() -> Picture | None:
        from torquerig.reporting.study import pictures

        shown = pictures.filtered(drive, chain, runs)
        return None if shown is None else pictures.first_picture(shown)

    return _kept(runs, "first", (_key(drive, runs), chain), draw)


def reading_pictures(
    drive: DriveResult, chain: str, runs: StudyRuns, *, role: str, number: int, with_signal: bool
) -> tuple[Picture, ...]:
    """Return time signal (where it is not the first picture) and spectrum; none for a drive that was not simulated."""

    def draw() -> tuple[Picture, ...]:
        from torquerig.reporting.study import pictures

        shown = pictures.filtered(drive, chain, runs)
        if shown is None:
            return ()
        moves = shown.before.samples <= MOST_SAMPLES
        made = pictures.reading_pictures(shown, role=role, number=number, with_signal=with_signal, moves=moves)
        return tuple(made)

    return _kept(runs, "readings", (_key(drive, runs), chain, role, number, with_signal), draw)


def report_filter(drive: DriveResult, runs: StudyRuns) -> tuple[Picture, Table] | None:
    """Return the spectrum before and after the report's filter, and the levels of its lines; None without them."""

    def draw() -> tuple[Picture, Table] | None:
        from torquerig.reporting.study import pictures

        return pictures.report_filter(drive, runs)

    return _kept(runs, "report filter", _key(drive, runs), draw)


def _kept(runs: StudyRuns, kind: str, content: object, draw: Callable[[], Drawn]) -> Drawn:
    shown = (kind, content, version("matplotlib"))
    return kept_or_made(runs.kept, "picture", shown, draw, classes=CLASSES)


def _key(drive: DriveResult, runs: StudyRuns) -> str:
    return runs.row_keys.get(drive.candidate.name, "")
