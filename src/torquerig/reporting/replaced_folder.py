"""A folder that is replaced whole or not at all."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from torquerig.errors import InputError


@contextmanager
def replaced_folder(folder: Path) -> Iterator[Path]:
    """Yield a temporary folder that replaces ``folder`` when all is written.

    On an error or Ctrl-C the new folder is removed and the old one is unchanged. Other files of the old
    folder are kept.

    Raises
    ------
    InputError
        When ``folder`` is a file, or the place cannot be written to.
    """
    folder = folder.resolve()
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder} is a file; name a folder for the report")
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        fresh = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.parent))
    except OSError as error:
        raise InputError(f"{folder}: no report can be written there ({error.strerror}); name another folder") from None
    try:
        fresh.chmod(0o755)
        yield fresh
        _swap(fresh, folder)
    except OSError as error:
        raise InputError(f"{error.filename or folder}: {error.strerror}; the old report is unchanged") from error
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def _swap(fresh: Path, folder: Path) -> None:
    """Rename the old folder away and the new one in; the old one comes back where the second rename fails."""
    if not folder.exists():
        fresh.rename(folder)
        return
    old = fresh.with_name(f"{fresh.name}-old")
    folder.rename(old)
    try:
        fresh.rename(folder)
    except BaseException:
        old.rename(folder)
        raise
    for kept in old.iterdir():
        if not (folder / kept.name).exists():
            kept.rename(folder / kept.name)
    shutil.rmtree(old, ignore_errors=True)
