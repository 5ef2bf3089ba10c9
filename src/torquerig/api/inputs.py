"""Scenarios and recordings that a function is given as values or as paths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from torquerig.api.recording_files import read
from torquerig.api.scenarios import read_scenario
from torquerig.api.values import folders
from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.recorded_drive import (
    RecordedDrive,
    at_stated_ratio,
    recorded_drive,
    refuse_other_travel,
)


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


def drive_from(
    recording: Recording, *, scenario: Scenario | str | Path | None, motor: str | None, ratio: float | None,
    gearbox: str | None, catalogs: Sequence[str | Path],
) -> RecordedDrive:  # fmt: skip
    """Return the drive that made a recording: of a scenario, else as given or stated by the recording.

    Raises
    ------
    InputError
        For a scenario together with motor, ratio or gearbox, or one whose gears contradict the recording.
    """
    if scenario is None:
        return recorded_drive(
            recording, motor=motor, ratio=ratio, gearbox=gearbox, catalogs=folders(catalogs),
            remedies=("motor=NAME", "ratio=N"),
        )  # fmt: skip
    if motor is not None or ratio is not None or gearbox is not None:
        raise InputError("the scenario states motor and gearbox; remove motor, ratio and gearbox")
    made = scenario_from(scenario, catalogs=catalogs)
    refuse_other_travel(made.rig, recording, made.title)
    return RecordedDrive(kinematics=at_stated_ratio(kinematics_of(made.rig), recording, made.title), rig=made.rig)
