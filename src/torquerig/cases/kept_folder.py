"""Where kept results are, and how many bytes they may take: options, environment, or the standard of the platform."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path

from torquerig.cases.kept_results import LIMIT
from torquerig.errors import InputError

FOLDER, LARGEST = "TORQUERIG_CACHE", "TORQUERIG_CACHE_LIMIT"
NONE = "none"
UNITS = {"": 1, "kB": 10**3, "MB": 10**6, "GB": 10**9, "KiB": 2**10, "MiB": 2**20, "GiB": 2**30}
_SIZE = re.compile(r"\s*(?P<number>\d+(?:\.\d+)?)\s*(?P<unit>[A-Za-z]*)\s*")


def kept_folder(stated: Path | None = None, environment: Mapping[str, str] = os.environ) -> Path | None:
    """Return the folder of kept results: as stated, else of ``TORQUERIG_CACHE``, else of the platform.

    The platform's is ``$XDG_CACHE_HOME/torquerig`` or ``~/.cache/torquerig`` on Linux, ``~/Library/Caches/torquerig``
    on macOS, ``torquerig/Cache`` in ``%LOCALAPPDATA%`` on Windows. None where the variable is ``none``.

    Raises
    ------
    InputError
        For the name of a file.
    """
    if stated is not None:
        return _no_file(stated, "--cache")
    named = environment.get(FOLDER, "").strip()
    if named == NONE:
        return None
    if named:
        return _no_file(Path(named), FOLDER)
    from platformdirs import user_cache_path

    return user_cache_path("torquerig", appauthor=False)


def _no_file(folder: Path, option: str) -> Path:
    if folder.is_file():
        raise InputError(f"{option}: {folder} is a file; name a folder, which need not exist yet")
    return folder


def kept_limit(environment: Mapping[str, str] = os.environ) -> int:
    """Return the most bytes that kept results may take: of ``TORQUERIG_CACHE_LIMIT`` such as ``500 MB``, else 2 GiB.

    Raises
    ------
    InputError
        For a text that is no size.
    """
    stated = environment.get(LARGEST, "").strip()
    if not stated:
        return LIMIT
    found = _SIZE.fullmatch(stated)
    if found is None or found["unit"] not in UNITS:
        raise InputError(f"{LARGEST}={stated}: this is no size; write a number with its unit, such as '500 MB'")
    return int(float(found["number"]) * UNITS[found["unit"]])


def size_text(size: float) -> str:
    """Return a number of bytes for people: ``4.1 MiB``."""
    for unit in ("KiB", "MiB"):
        size /= 1024
        if size < 1024:
            return f"{size:.1f} {unit}"
    return f"{size / 1024:.2f} GiB"
