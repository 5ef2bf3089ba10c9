"""What is in the folder of a studio: scenarios, sidecars, matrices, filter chains and recordings."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from torquerig.errors import InputError
from torquerig.recordings.files.reading import readers
from torquerig.studio.session.checked import kind_of
from torquerig.studio.session.file_on_disk import read_text

YAML = (".yaml", ".yml")
WORKBOOKS = (".xlsx", ".xlsm")


@dataclass(frozen=True)
class FolderFiles:
    """The files of a folder by what they are, each list sorted by name; ``others`` are YAML files of no known kind."""

    scenarios: tuple[Path, ...] = ()
    sheets: tuple[Path, ...] = ()
    matrices: tuple[Path, ...] = ()
    filters: tuple[Path, ...] = ()
    recordings: tuple[Path, ...] = ()
    others: tuple[Path, ...] = ()


def files_in(folder: Path) -> FolderFiles:
    """Return the files of a folder without its subfolders; hidden files and files half written are left out.

    Raises
    ------
    InputError
        Where the folder is missing or cannot be read.
    """
    try:
        files = sorted(one for one in folder.iterdir() if one.is_file() and not one.name.startswith("."))
    except OSError as error:
        raise InputError(f"{folder}: cannot be read ({error.strerror}); choose another folder") from None
    by_kind: dict[str, list[Path]] = {}
    for file in files:
        by_kind.setdefault(_kind(file), []).append(file)
    names = {
        "scenarios": "scenario", "sheets": "sheet", "matrices": "matrix", "filters": "filters",
        "recordings": "recording", "others": "other",
    }  # fmt: skip
    return FolderFiles(**{name: tuple(by_kind.get(kind, ())) for name, kind in names.items()})


def _kind(file: Path) -> str:
    ending = file.suffix.lower()
    if ending in YAML:
        try:
            return kind_of(read_text(file)[0], file)
        except InputError:
            return "other"
    return "recording" if ending in readers() else "none"
