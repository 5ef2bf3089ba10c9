"""Files that are written whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Lend a name beside ``path`` to write to; what is complete takes its place, what fails leaves nothing behind.

    The name has the ending of ``path``, by which some libraries choose a format, and the number of this process, so
    that two at once do not write into each other's. What is no file, as a pipe, is written to as it is.

    Raises
    ------
    OSError
        Where the folder cannot be written to; what stood at ``path`` is as it was.
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
