"""Values and folders in the form that the parts below take them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any


def folders(given: Sequence[str | Path]) -> list[Path]:
    """Return folders as paths."""
    return [Path(one) for one in given]


def settings_of(changes: Mapping[str, Any] | None) -> tuple[str, ...]:
    """Return changed values as the command line writes them: ``load.occupancy=21``."""
    return tuple(f"{path}={_written(value)}" for path, value in (changes or {}).items())


def _written(value: Any) -> str:
    """Return a value as YAML: text as it is, anything else as JSON, which is YAML."""
    return value if isinstance(value, str) else json.dumps(value)
