"""What is in the folder of a studio: scenarios, sidecars, matrices, filter chains and recordings."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from torquerig.errors import InputError
from torquerig.recordings.files.reading import readers
from torquerig.studio.session.checked import kind_of
from torquerig.studio.session.file_on_disk import read_text

SCENARIOS = "scenarios"  # folder that ``torquerig init`` writes next to ``catalogs``
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


def opened_at(where: Path) -> tuple[Path, Path | None]:
    """Return the folder of a studio and the scenario that it opens first, None for the first one of the folder.

    Where a folder has no scenario, but its folder ``scenarios/`` has some, that one is opened: ``torquerig init``
    writes it.

    Raises
    ------
    InputError
        Where the path is missing, or is a file that is no YAML.
    """
    if not where.exists():
        raise InputError(f"{where}: there is no such folder or scenario; check the path")
    if where.is_file():
        if where.suffix.lower() not in YAML:
            raise InputError(f"{where}: is no scenario, which is a YAML file; name a scenario, or the folder of "
                             "recordings and scenarios")  # fmt: skip
        return where.resolve().parent, where
    written = where / SCENARIOS
    if written.is_dir() and not files_in(where).scenarios and files_in(written).scenarios:
        return written, None
    return where, None


def _kind(file: Path) -> str:
    ending = file.suffix.lower()
    if ending in YAML:
        try:
            return kind_of(read_text(file)[0], file)
        except InputError:
            return "other"
    return "recording" if ending in readers() else "none"
