"""The ``--shell`` of ``torquerig size``: a sizing as an Asset Administration Shell with a submodel of IDTA 02021."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path
from uuid import uuid4

import click

from torquerig.catalog.exchange.motion_file import Motion, motion_file
from torquerig.catalog.exchange.shell_file import write_shell
from torquerig.catalog.exchange.sizing_submodel import MOTION_FILE, SizedDriveRecord, SizedFigure, environment_of
from torquerig.errors import InputError
from torquerig.metrics.sizing.drive_sizing import sizing
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.recordings.profiles.tabulated import Tabulated
from torquerig.reporting.sizing.sizing_text import verdict_text
from torquerig.rig.reading_place import reading_place
from torquerig.version import __version__


def check_shell(path: Path, *, overwrite: bool) -> None:
    """Raise InputError where the file of a shell is there already or has another ending."""
    if path.suffix not in (".json", ".aasx"):
        raise InputError(f"{path}: a shell is written as .json or .aasx; choose one of them")
    if path.exists() and not overwrite:
        raise InputError(f"{path}: is there already; overwrite it with --force")


def write_sizing_shell(path: Path, drive: SizedDrive, *, title: str, ambient: float) -> None:
    """Write the sizing of a drive; an ``.aasx`` also holds the motion where the profile states speed and load."""
    sized = sizing(drive, ambient=ambient)
    motion = _motion(drive) if path.suffix == ".aasx" else None
    components = [("Motor", drive.motor_name), *(("Gearbox", box.name) for box in drive.gearboxes.values())]
    figures = {
        name: SizedFigure(value=_number(one.value), low=_number(one.low), high=_number(one.high))
        for name, one in sized.figures.items()
    }
    record = SizedDriveRecord(
        title=title, tool=f"torquerig {__version__}", date=datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ"),
        components=components, verdict=verdict_text(sized), has_motion=motion is not None,
        figures=figures,
    )  # fmt: skip
    files = {MOTION_FILE: motion_file(motion).encode()} if motion else {}
    write_shell(path, environment_of(record, identifier=f"urn:uuid:{uuid4()}"), files)
    left = "" if motion else f"; without the motion of the load, {_why_not(drive, path)}"
    click.echo(f"{path}: written{left}")


def _number(value: float | None) -> float:
    return float("nan") if value is None else float(value)


def _motion(drive: SizedDrive) -> Motion | None:
    """Return the motion of the load; None where it is not stated as a table with torque, or moves in a line."""
    profile = drive.rig.run.set_points
    if _in_a_line(drive) or not isinstance(profile, Tabulated) or profile.rows.load is None:
        return None
    output = profile.rows.times(1 / drive.ratio)
    return Motion(output.time, output.speed, profile.rows.load)


def _in_a_line(drive: SizedDrive) -> bool:
    return drive.rig.in_a_line(drive.rig.part(reading_place(drive.rig)))


def _why_not(drive: SizedDrive, path: Path) -> str:
    if path.suffix == ".json":
        return "which only .aasx holds"
    return "which moves in a line" if _in_a_line(drive) else "whose torque the profile does not state"
