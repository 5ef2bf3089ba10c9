"""The recordings that a command line names: files, and folders for all recordings in them."""

from __future__ import annotations

from pathlib import Path

from torquerig.errors import InputError
from torquerig.recordings.files.reading import readers


def recordings_in(path: Path) -> list[Path]:
    """Return the file itself, or the recordings in a folder by name, without its subfolders.

    Raises
    ------
    InputError
        A folder without a recording.
    """
    if not path.is_dir():
        return [path]
    found = sorted(one for one in path.iterdir() if one.is_file() and one.suffix.lower() in readers())
    if not found:
        raise InputError(f"{path}: there is no recording in this folder; readable are {', '.join(readers())}")
    return found
