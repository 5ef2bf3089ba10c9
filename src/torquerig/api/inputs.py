"""Scenarios and recordings that a function is given as values or as paths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from torquerig.api.recording_files import read
from torquerig.api.scenarios import read_scenario
from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario


def scenario_from(
    given: Scenario | str | Path, *, changes: Mapping[str, Any] | None = None, motor: str | None = None,
    gearbox: str | None = None, catalogs: Sequence[str | Path] = (), seed: int = 1,
) -> Scenario:  # fmt: skip
    """Return a scenario as it is, or read it from its file; InputError for changes to one that was read already."""
    if not isinstance(given, Scenario):
        return read_scenario(given, changes=changes, motor=motor, gearbox=gearbox, catalogs=catalogs, seed=seed)
    if changes or motor or gearbox or catalogs:
        raise InputError(
            f"{given.title}: this scenario was read already; give changes, motor, gearbox and catalogs to read_scenario"
        )
    return given


def recording_from(given: Recording | str | Path) -> Recording:
    """Return a recording as it is, or read it from its file."""
    return given if isinstance(given, Recording) else read(given)
