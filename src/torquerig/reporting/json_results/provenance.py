"""Where a result comes from: version, hash of the sources, hash of each input file, seed."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from torquerig.reporting.json_results.values import Missing
from torquerig.version import __version__

NOTHING_KEPT = Missing("no results of drives were read from the cache or kept there")


@dataclass(frozen=True)
class Provenance:
    """What the result depends on: the same values give the same result, whatever was read from the cache.

    Parameters
    ----------
    torquerig : str
        Version of the program.
    source_sha256 : str
        SHA-256 of the Python files of the program.
    inputs_sha256 : mapping of str to str
        SHA-256 of each input file that the command line names, by its name; of all catalog files together under
        ``catalogs`` where the command reads catalogs.
    seed : int or None
        Seed of the random numbers; None where the command draws none.
    options : mapping
        Options and arguments that the command line states, without inputs and ``--json``; of paths the name.
    from_cache : int or None
        How many results of drives were kept ones of an earlier call; None where the command kept none. The result does
        not depend on it.
    """

    torquerig: str
    source_sha256: str
    inputs_sha256: Mapping[str, str]
    seed: int | Missing
    options: Mapping[str, Any]
    from_cache: int | Missing = NOTHING_KEPT


def provenance_of(
    inputs: Iterable[Path], *, seed: int | None, catalogs: Iterable[Path] = (), options: Mapping[str, Any] | None = None
) -> Provenance:
    """Return the provenance of a result that is computed from these files and catalog folders with this seed."""
    of_catalogs = {"catalogs": folders_sha256(catalogs)} if catalogs else {}
    return Provenance(
        torquerig=__version__,
        source_sha256=source_sha256(),
        inputs_sha256={**hashes_of(inputs), **of_catalogs},
        seed=Missing("the command draws no random numbers") if seed is None else seed,
        options=options or {},
    )


@cache
def source_sha256() -> str:
    """Return the SHA-256 of the names and contents of all Python files of torquerig."""
    return folders_sha256([Path(__file__).resolve().parents[2]], pattern="*.py")


def folders_sha256(folders: Iterable[Path], *, pattern: str = "*.yaml") -> str:
    """Return the SHA-256 of the names and contents of all files of this pattern in some folders."""
    digest = hashlib.sha256()
    for folder in folders:
        for path in sorted(folder.rglob(pattern)):
            digest.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()


def hashes_of(inputs: Iterable[Path]) -> dict[str, str]:
    """Return the SHA-256 of each file that is there; by its name, by its path where two files have one name."""
    files = [path for path in dict.fromkeys(inputs) if path.is_file()]
    often = Counter(path.name for path in files)
    return {path.name if often[path.name] == 1 else path.as_posix(): file_sha256(path) for path in files}


def file_sha256(path: Path) -> str:
    """Return the SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
