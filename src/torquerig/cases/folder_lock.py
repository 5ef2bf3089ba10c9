"""A folder that one process writes to at a time; a process that died holds nothing."""

from __future__ import annotations

import os
import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from torquerig.errors import InputError


@contextmanager
def folder_lock(folder: Path) -> Iterator[None]:
    """Hold the lock of a folder; the system gives it back when the process ends, however it ends.

    On a network drive this holds between machines where the drive knows locks (NFS from version 4 on, SMB).

    Raises
    ------
    InputError
        When another process holds it, with its number and machine.
    """
    with (folder / ".lock").open("a+", encoding="utf-8") as file:
        if not _taken(file):
            file.seek(0)
            who = file.read(200).strip() or "another process"
            raise InputError(f"{folder} is being written by {who}; wait until it ends, or give another folder")
        file.truncate(0)
        file.write(f"process {os.getpid()} on {socket.gethostname()}")
        file.flush()
        yield


_LOCKED_BYTE = 4096  # far behind the text, so that others can still read who holds the lock


def _taken(file: IO[str]) -> bool:
    if os.name == "nt":
        return _taken_on_windows(file)
    import fcntl

    with suppress(BlockingIOError):
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        return True
    return False


def _taken_on_windows(file: IO[str]) -> bool:
    import msvcrt

    file.seek(_LOCKED_BYTE)
    with suppress(OSError):
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined, unused-ignore]
        return True
    return False
