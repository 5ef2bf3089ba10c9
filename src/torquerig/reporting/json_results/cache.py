"""The result of ``torquerig cache``: what is kept, and what was removed."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.reporting.json_results.values import Missing


@dataclass(frozen=True)
class CacheResult:
    """The kept results of a folder, after what was removed.

    ``oldest_days`` and ``newest_days`` are the times since the results were used last that were used longest ago and
    most recently.
    """

    folder: str
    entries: int
    bytes: int
    limit_bytes: int
    oldest_days: float | Missing
    newest_days: float | Missing
    removed_entries: int
    removed_bytes: int
