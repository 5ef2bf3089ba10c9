"""Files that are dropped on the page: written whole into the folder, and never over another file."""

from __future__ import annotations

from collections.abc import AsyncIterable
from pathlib import Path

from torquerig.errors import InputError
from torquerig.harmless import harmless
from torquerig.recordings.files.reading import readers
from torquerig.studio.session.folder_files import YAML
from torquerig.whole_file import whole_file

LONGEST_NAME = 200  # [characters] file systems allow 255 bytes
FORBIDDEN = '<>:"/\\|?*'
"""Signs that Windows refuses in a name; a slash would lead into another folder."""


async def received(folder: Path, name: str, pieces: AsyncIterable[bytes]) -> Path:
    """Write a file into the folder piece by piece, and return its path.

    Parameters
    ----------
    folder : Path
    name : str
        As the browser states it.
    pieces : async iterable of bytes

    Raises
    ------
    InputError
        Where the name cannot be that of a file, a file of that name is there, or the folder cannot be written to.
        Nothing is left of a file that did not arrive whole.
    """
    path = folder / checked_name(name)
    if path.exists():
        raise InputError(f"{path.name}: is there already; rename one of the two files")
    try:
        with whole_file(path) as partial:
            with partial.open("wb") as file:
                async for piece in pieces:
                    file.write(piece)
            if path.exists():
                raise InputError(f"{path.name}: is there already; rename one of the two files")
    except OSError as error:
        raise InputError(f"{path.name}: cannot be written ({error.strerror}); nothing was kept") from None
    return path


def arrival_sentence(name: str) -> str:
    """Return the sentence for a file that was written, which may be one that no reader takes."""
    ending = Path(name).suffix.lower()
    if ending in readers() or ending in YAML:
        return f"{name}: received"
    known = ", ".join(sorted(readers()))
    return f"{name}: received, but not listed: no recording ends in {ending or 'nothing'}; known are {known}"


def checked_name(name: str) -> str:
    """Return the name of a file without folders; InputError where it cannot be one."""
    last = name.replace("\\", "/").rpartition("/")[2].strip()
    is_bad = not last or last.startswith(".") or harmless(last) != last or any(sign in FORBIDDEN for sign in last)
    if is_bad or len(last) > LONGEST_NAME:
        raise InputError(f"{harmless(name)[:LONGEST_NAME]!r} cannot be the name of a file; rename it and drop it again")
    return last
