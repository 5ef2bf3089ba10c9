"""Check of output paths: never over an input, nor over a file that another program wrote."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from pathlib import Path

from torquerig.errors import InputError
from torquerig.whole_file import refuse_unwritable

_MARK_WITHIN = 4096  # [byte] the mark of an earlier file must be in these first bytes


def check_output_paths(targets: Iterable[tuple[Path, str]], *, inputs: Iterable[Path], what: str = "diagnosis") -> None:
    """Raise InputError where a file may not be written.

    Parameters
    ----------
    targets : iterable of (Path, str)
        Each with the mark near the beginning of files of the same command. Only such files and empty ones are replaced.
    inputs : iterable of Path
        Files that the command reads.
    """
    every, read = list(targets), {path.resolve() for path in inputs}
    for (one, _), (other, _) in combinations(every, 2):
        if one.resolve() == other.resolve():
            raise InputError(f"{one}: two outputs have this path; name two files")
    for path, mark in every:
        if not path.parent.is_dir():
            raise InputError(f"{path}: there is no folder {path.parent}; make it first")
        if path.is_dir():
            raise InputError(f"{path}: is a folder; name a file in it")
        if path.resolve() in read:
            raise InputError(f"{path}: is one of the inputs; choose another name to write to")
        if path.is_file() and not _replaceable(path, mark):
            raise InputError(f"{path}: is there already and no {what}; choose another name, or delete it")
        refuse_unwritable(path)


def _replaceable(path: Path, mark: str) -> bool:
    with path.open("rb") as file:
        start = file.read(_MARK_WITHIN)
    return not start or mark.encode() in start
