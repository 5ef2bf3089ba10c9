"""The recordings that a scenario's parts replay: they are part of what determines the rows of a study."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields
from functools import lru_cache
from pathlib import Path

from torquerig.cases import digest_of
from torquerig.recordings.files.sidecar_choice import find_sidecar
from torquerig.rig.assembly import Rig

FILES = 16  # whose digest is kept as long as they stay the same


def replayed_files(rigs: Iterable[Rig]) -> dict[str, str]:
    """Return the digest of each recording that a part of one of the rigs replays, with its sidecar, by path."""
    named = {
        value
        for rig in rigs
        for part in rig.parts
        for value in (getattr(part, one.name) for one in fields(part))
        if isinstance(value, Path)
    }
    return {str(path): _digest_now(path) for path in sorted(named)}


def changed_file(digests: Mapping[str, str]) -> str:
    """Return the first of these files whose content is another now; empty where none has changed."""
    return next((path for path, stated in digests.items() if _digest_now(Path(path)) != stated), "")


def _digest_now(path: Path) -> str:
    sidecar = find_sidecar(path)
    try:
        return " ".join(_digest(one, *_state(one)) for one in (path, sidecar) if one is not None)
    except OSError:
        return "cannot be read"


def _state(path: Path) -> tuple[int, int]:
    found = path.stat()
    return found.st_mtime_ns, found.st_size


@lru_cache(maxsize=FILES)
def _digest(path: Path, changed: int, size: int) -> str:
    return digest_of(path.read_bytes())
