"""The catalog of a folder while its files may change: read again when they do; a bad file keeps the last good one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.search import catalog_folders
from torquerig.errors import TorquerigError
from torquerig.studio.session.problem import Problem, problems_of

Mark = tuple[tuple[str, int, int], ...]


@dataclass(frozen=True)
class CatalogState:
    """The last good catalog of a place, what is wrong with its files now, and by what a change of them is seen.

    Parameters
    ----------
    near : Path
        A scenario, or a file name in its folder: catalogs next to it are read too.
    further : sequence of Path
    catalog : Catalog
        Empty where the files have never been right.
    problems : tuple of Problem
    mark : tuple
        Name, size and time of change of each file.
    """

    near: Path
    further: Sequence[Path]
    catalog: Catalog
    problems: tuple[Problem, ...]
    mark: Mark

    def current(self) -> CatalogState:
        """Return the state with the files read again where one has changed; itself where none has."""
        try:
            mark = _mark(catalog_folders(self.near, self.further))
        except (TorquerigError, OSError):
            mark = ()
        return self if mark == self.mark else _read(self.near, self.further, self.catalog, mark)


def catalog_state(near: Path, further: Sequence[Path] = ()) -> CatalogState:
    """Return the catalog for scenarios in the folder of ``near``; what is wrong with it is in ``problems``."""
    return CatalogState(near, tuple(further), Catalog(), (), (("", -1, -1),)).current()


def _read(near: Path, further: Sequence[Path], last: Catalog, mark: Mark) -> CatalogState:
    try:
        return CatalogState(near, further, load_catalog(*catalog_folders(near, further)), (), mark)
    except TorquerigError as error:
        found = problems_of(error, None, near.parent)
    except OSError as error:
        found = (Problem((), None, f"cannot be read ({error.strerror})", Path(error.filename or near.parent)),)
    return CatalogState(near, further, last, found, mark)


def _mark(folders: Sequence[Path]) -> Mark:
    files = [file for folder in folders for file in sorted(folder.glob("*/*.y*ml"))]
    found = []
    for file in files:
        try:
            known = file.stat()
        except OSError:
            continue  # deleted meanwhile
        found.append((str(file), known.st_size, known.st_mtime_ns))
    return tuple(found)
