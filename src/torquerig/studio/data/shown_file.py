"""What is in a recording file and what each column is taken for, as plain values for the page."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from torquerig.errors import TorquerigError
from torquerig.recordings.inspection.draft_sidecar import draft_sidecar
from torquerig.recordings.inspection.file_contents import ColumnContents, file_contents
from torquerig.schema_comment import schema_comment

HEAD = ("column", "taken for", "unit", "known by", "rate", "samples", "minimum", "mean", "maximum")


@dataclass(frozen=True)
class ShownFile:
    """A recording file.

    Parameters
    ----------
    name : str
    columns : tuple of str
    rows : tuple of rows
        Under ``HEAD``.
    needed : mapping-like tuple of (column, what a sidecar must add)
    notes : tuple of str
        What the reader understood, and the columns that it left out.
    problem : str
        Why it cannot be used as it is, with the remedy; empty where it can.
    draft : str
        A sidecar that states what is known; empty where nothing can be read.
    """

    name: str
    columns: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    needed: tuple[tuple[str, str], ...] = ()
    notes: tuple[str, ...] = ()
    problem: str = ""
    draft: str = ""


def shown_file(path: Path, sheet: Path) -> ShownFile:
    """Return what is in a file; a file that cannot be read is its name and the problem.

    Parameters
    ----------
    path : Path
        Of the recording.
    sheet : Path
        Where its sidecar is or will be.
    """
    try:
        contents = file_contents(path)
    except TorquerigError as error:
        return ShownFile(path.name, problem=str(error))
    skipped = (f"{name}: left out: {reason}" for name, reason in contents.skipped.items())
    gone = (f"{one.name}: {one.gone} samples are no finite number" for one in contents.columns if one.gone)
    return ShownFile(
        name=path.name,
        columns=tuple(one.name for one in contents.columns),
        rows=tuple(_row(one) for one in contents.columns),
        needed=tuple(contents.missing().items()),
        notes=(*contents.notes, *skipped, *gone),
        problem=contents.problem,
        draft=schema_comment(sheet, "sidecar") + draft_sidecar(contents),
    )


def _row(one: ColumnContents) -> tuple[str, ...]:
    rate = "not known" if one.rate is None else f"{one.rate:g} Hz"
    figures = (f"{number:.5g}" for number in (one.minimum, one.mean, one.maximum))
    known = "not known" if one.missing else one.reason or "the sidecar"
    return (one.name, one.quantity, one.unit or "not known", known, rate, str(one.samples), *figures)
