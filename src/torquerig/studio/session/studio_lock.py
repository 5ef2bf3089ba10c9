"""One studio per folder: a second one is refused with one sentence, and a studio that died holds nothing."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from torquerig.cases.folder_lock import folder_lock
from torquerig.errors import InputError

KEPT = ".torquerig-studio"
"""Hidden folder of a studio's own files in the folder that it works on."""


@contextmanager
def studio_lock(folder: Path) -> Iterator[Path]:
    """Hold a folder for this studio, and yield the hidden folder for the studio's files.

    Raises
    ------
    InputError
        Where another studio works on the folder, or nothing can be written into it.
    """
    if not folder.is_dir():
        raise InputError(f"{folder}: there is no such folder; check the path")
    kept = folder / KEPT
    try:
        kept.mkdir(exist_ok=True)
        lock = folder_lock(kept)
        lock.__enter__()
    except InputError as error:
        who = str(error).partition("is being written by ")[2].partition(";")[0] or "another process"
        raise InputError(f"{folder}: a studio works on this folder already ({who}); use its page, or end it first"
                         ) from None  # fmt: skip
    except OSError as error:
        raise InputError(f"{folder}: cannot be written to ({error.strerror}); the studio saves its files there, so "
                         "choose another folder") from None  # fmt: skip
    try:
        yield kept
    finally:
        lock.__exit__(None, None, None)
