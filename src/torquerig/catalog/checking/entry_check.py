"""The check of catalog files: whether they are read, what contradicts, what is open and what that costs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from torquerig.catalog.checking.contradictions import contradictions
from torquerig.catalog.checking.costs import Cost, costs
from torquerig.catalog.entry import Entry
from torquerig.catalog.part_class import KINDS, PartClass
from torquerig.catalog.reading import SHELVES, read_entry
from torquerig.document import read_document
from torquerig.errors import InputError, TorquerigError

BY_KIND = {"pmsm": "motor", "bldc": "motor", "induction": "motor", "planetary": "gearbox", "spur": "gearbox",
           "belt": "gearbox", "worm": "gearbox", "bellows": "coupling", "jaw": "coupling"}  # fmt: skip


@dataclass(frozen=True)
class EntryCheck:
    """The check of one file.

    Parameters
    ----------
    path : Path
    name, title : str
        Empty where the file cannot be read.
    problem : str
        Why it cannot be read, one sentence per line; empty where it can.
    contradictions : tuple of str
    costs : tuple of Cost
        The dearest first.
    """

    path: Path
    name: str
    title: str
    problem: str = ""
    contradictions: tuple[str, ...] = ()
    costs: tuple[Cost, ...] = ()


def check_file(path: Path, classes: Mapping[str, PartClass]) -> EntryCheck:
    """Return the check of one catalog file; a file that cannot be read is a result, with the reason."""
    try:
        entry = read_entry(path, kind_of_file(path), classes)
    except TorquerigError as error:
        return EntryCheck(path, "", "", problem=str(error))
    return EntryCheck(path, entry.name, entry.title, "", tuple(contradictions(entry)), tuple(costs(entry)))


def kind_of_file(path: Path) -> type[Entry]:
    """Return the schema of a file: by its folder, else by its ``kind``, else a sensor where it has a range.

    Raises
    ------
    InputError
        Where none of them decides.
    """
    if path.resolve().parent.name in SHELVES:
        return SHELVES[path.resolve().parent.name]
    data = read_document(path).data
    if isinstance(data, dict):
        if data.get("kind") in BY_KIND:
            return KINDS[BY_KIND[data["kind"]]]
        if "range_torque" in data or "sensitivity" in data:
            return KINDS["sensor"]
    raise InputError(
        f"{path}: is it a motor, gearbox, sensor or coupling? put it into one of the folders {', '.join(SHELVES)}, or "
        "state its kind"
    )


def files_in(path: Path) -> Sequence[Path]:
    """Return the files of entries in a file, shelf or catalog folder; InputError where there are none."""
    if path.is_file():
        return [path]
    if not path.exists():
        raise InputError(f"{path}: there is no such file or folder; check the path")
    shelves = [path] if path.name in SHELVES else [path / shelf for shelf in SHELVES]
    found = [file for shelf in shelves for file in sorted(shelf.glob("*.y*ml"))]
    if not found:
        raise InputError(f"{path}: has no catalog files in {', '.join(SHELVES)}; name a file, or the folder above them")
    return found
