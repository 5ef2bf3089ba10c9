"""What is asked of a study, and what it answers, as plain values that go between two processes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from torquerig.studio.shown_answer import ShownAnswer


@dataclass(frozen=True)
class StudyQuestion:
    """A study that is wanted.

    Parameters
    ----------
    path : Path
        File of the scenario, from whose folder the filters are read.
    text : str
        The scenario as it is edited.
    catalogs : tuple of Path
        Further catalog folders.
    workers : int or None
        Runs at a time; one per core where None.
    """

    path: Path
    text: str
    catalogs: tuple[Path, ...] = ()
    workers: int | None = None


@dataclass(frozen=True)
class StudyShown:
    """A study.

    Parameters
    ----------
    answer : ShownAnswer
    model : mapping
        The three matrices as numbers, which the page computes again; see ``reporting.moving.matrix_model``.
    not_ranked : tuple of (drive, decision, reasons)
        Drives that are eliminated or open, and why.
    drives, from_store : int
        How many drives were compared, and of how many the results were stored.
    page : str
        The report as one HTML file.
    """

    answer: ShownAnswer
    model: Mapping[str, Any]
    not_ranked: tuple[tuple[str, str, str], ...]
    drives: int
    from_store: int
    page: str
