"""What is asked of a diagnosis, and what it answers, as plain values that go between two processes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from torquerig.studio.shown_answer import ShownAnswer, ShownPicture


@dataclass(frozen=True)
class DiagnosisQuestion:
    """A diagnosis that is wanted.

    Parameters
    ----------
    path : Path
        File of the scenario, from whose folder other files are read.
    text : str
        The scenario as it is edited.
    recordings : tuple of Path
    catalogs : tuple of Path
        Further catalog folders.
    seed : int
        Of all random numbers.
    workers : int
        Fits at a time.
    """

    path: Path
    text: str
    recordings: tuple[Path, ...]
    catalogs: tuple[Path, ...] = ()
    seed: int = 0
    workers: int = 1


@dataclass(frozen=True)
class DiagnosisShown:
    """A diagnosis.

    Parameters
    ----------
    data : mapping
        In the form of the contract, with provenance.
    answer : ShownAnswer
    lines : tuple of str
        The same as the command prints it.
    pictures : tuple of ShownPicture
        Measured, nominal and completed; empty under measured motion.
    model : str or None
        The completed scenario as the text of a file; None where nothing was added.
    page : str or None
        The page as one HTML file; None where none is made.
    each : tuple of rows
        How much each part that was added changes the reading; see ``each_effect``. Empty under measured motion.
    """

    data: Mapping[str, Any]
    answer: ShownAnswer
    lines: tuple[str, ...]
    pictures: tuple[ShownPicture, ...]
    model: str | None
    page: str | None
    each: tuple[tuple[str, str, str, str], ...] = ()
