"""Checksum of the sources of the compiled loop, which changes with any file of this package.

Numba's cache on disk is keyed by the bytes of the compiled function and the values that it closes over, not by the
functions in other files that it calls. The loop closes over this number, so a change of any of them compiles it anew.
"""

from __future__ import annotations

import zlib
from pathlib import Path


def sources_key() -> int:
    """Return the checksum of the source files of this package, in the order of their names."""
    files = sorted(Path(__file__).parent.glob("*.py"))
    return zlib.crc32(b"\0".join(file.read_bytes() for file in files))
