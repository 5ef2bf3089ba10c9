"""Files that are written completely or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


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
    if path.exists() and not path.is_file():
        yield path
        return
    partial = path.with_name(f".{path.stem}.{os.getpid()}.partial{path.suffix}")
    try:
        yield partial
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)
