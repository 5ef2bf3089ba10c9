"""A folder that is replaced whole or not at all."""

from __future__ import annotations

import ctypes
import os
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from torquerig.errors import InputError
from torquerig.whole_file import clear_leftovers, remove, temporary_name

_HERE, _EXCHANGE = -100, 2  # AT_FDCWD and RENAME_EXCHANGE of Linux (renameat2(2))


@contextmanager
def replaced_folder(folder: Path) -> Iterator[Path]:
    """Yield a temporary folder that replaces ``folder`` when all is written.

    On an error or Ctrl-C the new folder is removed and the old one is unchanged. Other files of the old folder are
    kept. What a killed run left is removed by the next one.

    Raises
    ------
    InputError
        When ``folder`` is a file, or the place cannot be written to.
    """
    folder = folder.resolve()
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder} is a file; name a folder for the report")
    fresh = temporary_name(folder, "partial")
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        clear_leftovers(folder.parent)
        remove(fresh)
        fresh.mkdir()
    except OSError as error:
        raise InputError(f"{folder}: no report can be written there ({error.strerror}); name another folder") from None
    try:
        yield fresh
        if folder.exists():
            _keep_other_files(folder, fresh)
            _exchange(fresh, folder)
        else:
            fresh.rename(folder)
    except OSError as error:
        raise InputError(f"{error.filename or folder}: {error.strerror}; the old report is unchanged") from error
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def _keep_other_files(folder: Path, fresh: Path) -> None:
    """Give the new folder what the old one has and it has not: second names of files, copies where there are none."""
    for kept in folder.iterdir():
        target = fresh / kept.name
        if target.exists():
            continue
        if kept.is_dir() and not kept.is_symlink():
            shutil.copytree(kept, target, symlinks=True, copy_function=_second_name)
        else:
            _second_name(kept, target)


def _second_name(source: str | Path, target: str | Path) -> str | Path:
    try:
        os.link(source, target, follow_symlinks=False)
    except OSError:
        shutil.copy2(source, target, follow_symlinks=False)
    return target


def _exchange(fresh: Path, folder: Path) -> None:
    """Exchange two folders: in one step where the system can, else by two renames, the first of which is undone."""
    if _exchanged_at_once(fresh, folder):
        return
    old = temporary_name(folder, "before")
    remove(old)
    folder.rename(old)
    try:
        fresh.rename(folder)
    except BaseException:
        old.rename(folder)
        raise
    shutil.rmtree(old, ignore_errors=True)


def _exchanged_at_once(one: Path, other: Path) -> bool:
    """Exchange two paths by ``renameat2``; return whether that was possible."""
    if not sys.platform.startswith("linux"):
        return False
    try:
        renameat2 = ctypes.CDLL(None).renameat2
    except (OSError, AttributeError):  # an old C library
        return False
    return bool(renameat2(_HERE, os.fsencode(one), _HERE, os.fsencode(other), _EXCHANGE) == 0)
