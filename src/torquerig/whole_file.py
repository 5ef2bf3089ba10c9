"""Files that are written completely or not at all, alone or together; and what killed runs left behind."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

# .NAME.PID.partial.ENDING is half written; .NAME.PID.before.ENDING is the old file while several are exchanged
_LEFT = re.compile(r"\.(?P<name>.+)\.(?P<process>\d+)\.(?P<what>partial|before)(?P<ending>\.[^.]*)?")


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Yield a temporary path in the same folder; it replaces ``path`` on success and is deleted on failure.

    The name has the ending of ``path``, by which some libraries choose a format, and the process id, so that two
    processes do not conflict. A pipe is written to directly.

    Raises
    ------
    OSError
        Where the folder cannot be written to; the file at ``path`` is unchanged.
    """
    with whole_files([path]) as (partial,):
        yield partial


@contextmanager
def whole_files(paths: Sequence[Path]) -> Iterator[list[Path]]:
    """Yield a temporary path for each path; all replace their targets on success, none does on failure.

    All new files are complete before the first is exchanged. The old files are kept under another name until the last
    is exchanged; where that fails, or the process is killed meanwhile, they come back: here, or in the next run.

    Raises
    ------
    OSError
        Where a folder cannot be written to; the files at ``paths`` are unchanged.
    """
    for folder in {path.parent for path in paths}:
        clear_leftovers(folder)
    partials = [path if _is_pipe(path) else temporary_name(path, "partial") for path in paths]
    written = [(partial, path) for partial, path in zip(partials, paths, strict=True) if partial != path]
    try:
        yield partials
        for partial, _ in written:
            _save(partial)
        _exchange(written)
    except Exception as error:
        found = _system_error(error)
        if found is None:
            raise
        names = {str(partial): str(path) for partial, path in written}
        raise OSError(
            found, os.strerror(found), names.get(str(getattr(error, "filename", "")), str(paths[0]))
        ) from error
    finally:
        for partial, _ in written:
            partial.unlink(missing_ok=True)


def refuse_unwritable(path: Path) -> None:
    """Raise the OSError that writing to ``path`` would raise, before a long calculation; makes nothing."""
    if _is_pipe(path):
        return
    folder = path.parent
    while not folder.exists() and folder != folder.parent:  # it will be made
        folder = folder.parent
    probe = temporary_name(folder / path.name, "partial")
    try:
        with probe.open("xb"):
            pass
    except FileExistsError:
        return
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None
    probe.unlink(missing_ok=True)


def clear_leftovers(folder: Path) -> None:
    """Remove what killed runs left in a folder, and give old files back where they had not exchanged all of them.

    Only names with the number of a process that does not run any more count. Where a leftover cannot be removed, it
    stays.
    """
    try:
        hidden = [(found, _LEFT.fullmatch(found.name)) for found in folder.iterdir() if found.name.startswith(".")]
    except OSError:  # the attempt to write will name the reason
        return
    left = [(found, match) for found, match in hidden if match and not _runs(int(match["process"]))]
    unfinished = {match["process"] for _, match in left if match["what"] == "partial"}
    for found, match in sorted(left, key=lambda one: one[1]["what"]):  # what was before, first
        target = found.with_name(f"{match['name']}{match['ending'] or ''}")
        comes_back = match["what"] == "before" and match["process"] in unfinished
        with suppress(OSError):
            if comes_back and not (found.is_dir() and target.exists()):
                found.replace(target)
            remove(found)


def remove(path: Path) -> None:
    """Remove a file, or a folder with all that is in it; nothing where it is not there."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def temporary_name(path: Path, what: str) -> Path:
    """Return the name of the temporary file or folder for ``path``; ``what`` is ``partial`` or ``before``."""
    return path.with_name(f".{path.stem}.{os.getpid()}.{what}{path.suffix}")


def _is_pipe(path: Path) -> bool:
    return path.exists() and not path.is_file()


def _system_error(error: Exception) -> int | None:
    """Return the number of the system's error behind an error of a library, which may wrap it; None for others."""
    behind = (error, error.__cause__, error.__context__, *error.args)
    for one in behind:
        if isinstance(one, OSError) and one.errno:
            return one.errno
    stated = re.search(r"errno[ =:]*(\d+)", str(error))  # h5py states the number in words
    return int(stated[1]) if stated else None


def _save(partial: Path) -> None:
    """Wait until the file is on the disk, so that a full disk or a power failure does not cost the old one."""
    with partial.open("r+b") as file:
        os.fsync(file.fileno())


def _exchange(written: Sequence[tuple[Path, Path]]) -> None:
    """Rename each partial file to its target; on failure every target is as it was."""
    with ExitStack() as undo:
        several = len(written) > 1
        before = {path: _kept(path) for _, path in written if several and path.exists()}
        for path, old in before.items():
            undo.callback(_restore, old, path)
        for partial, path in written:
            if several and path not in before:
                undo.callback(path.unlink, missing_ok=True)
            partial.replace(path)
        undo.pop_all()
    for old in before.values():
        old.unlink(missing_ok=True)


def _restore(old: Path, path: Path) -> None:
    if old.exists():
        old.replace(path)
        old.unlink(missing_ok=True)  # it stays where both were names of one file


def _kept(path: Path) -> Path:
    """Return a second name of the file at ``path``, or a copy where the file system has no links."""
    old = temporary_name(path, "before")
    old.unlink(missing_ok=True)
    try:
        os.link(path, old)
    except OSError:
        shutil.copy2(path, old)
    return old


def _runs(process: int) -> bool:
    """Whether a process of this number runs; where that cannot be known (Windows), it counts as running."""
    if os.name == "nt" or process <= 0:
        return True
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):  # it runs as another user, or the number is none
        return True
    return True
