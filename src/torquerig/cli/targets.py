"""Where a command may write: never over what it reads, nor over what another kind of work has left there."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from pathlib import Path

from torquerig.errors import InputError

_LOOKED_AT = 4096  # bytes of an earlier file in which its mark must stand


def check_targets(targets: Iterable[tuple[Path, str]], *, inputs: Iterable[Path]) -> None:
    """Raise InputError where a file may not be written.

    Parameters
    ----------
    targets : iterable of (Path, str)
        Each with a mark that stands near the beginning of what the same command wrote there before, which alone is
        replaced; so are empty files.
    inputs : iterable of Path
        What the command reads.
    """
    every, read = list(targets), {path.resolve() for path in inputs}
    for (one, _), (other, _) in combinations(every, 2):
        if one.resolve() == other.resolve():
            raise InputError(f"{one}: two results would be written there; name two files")
    for path, mark in every:
        if not path.parent.is_dir():
            raise InputError(f"{path}: there is no folder {path.parent}; make it first")
        if path.is_dir():
            raise InputError(f"{path}: is a folder; name a file in it")
        if path.resolve() in read:
            raise InputError(f"{path}: is one of the inputs; choose another name to write to")
        if path.is_file() and not _replaceable(path, mark):
            raise InputError(f"{path}: is there already and no diagnosis; choose another name, or delete it")


def _replaceable(path: Path, mark: str) -> bool:
    with path.open("rb") as file:
        start = file.read(_LOOKED_AT)
    return not start or mark.encode() in start
