"""Read a profile from a table file with the columns time_s, a speed, and optionally a load torque."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError, did_you_mean
from torquerig.recordings.files.reading import readers
from torquerig.recordings.profiles.breakpoints import Breakpoints
from torquerig.recordings.profiles.table_checks import refuse_gaps
from torquerig.units import UNITS

TEXTS = (".csv", ".tsv", ".txt", ".dat")
# column -> whether it is the output shaft's; a bare speed_rpm is the motor's, as in a sidecar
SPEEDS = {"speed_rpm": False, "motor_speed_rpm": False, "output_speed_rpm": True}
LOADS = ("torque_Nm", "load_torque_Nm")


def read_profile(path: Path) -> tuple[Breakpoints, bool]:
    """Return the breakpoints of a profile, and whether its speeds are those of the output shaft.

    Any table file in a format of recordings. Columns: ``time_s`` [s], one of ``speed_rpm`` (of the motor),
    ``motor_speed_rpm`` and ``output_speed_rpm``, and optionally ``torque_Nm``, the load at the wear part.

    Raises
    ------
    InputError
        With file, line and remedy: a missing column, a gap, a time that does not rise.
    RecordingError
        A file that cannot be read as a table.
    """
    columns = _columns(path)
    if "time_s" not in columns:
        raise InputError(f"{path}: a profile needs the column time_s; {did_you_mean('time_s', columns)}")
    found = [name for name in SPEEDS if name in columns]
    if len(found) != 1:
        has = " and ".join(found) or "none"
        raise InputError(f"{path}: a profile needs one column of speed, {', '.join(SPEEDS)}; it has {has}")
    load = next((name for name in LOADS if name in columns), None)
    used = {name: columns[name] for name in ("time_s", found[0], *([load] if load else []))}
    rows = {values.size for values in used.values()}
    if len(rows) > 1 or rows == {0}:
        raise InputError(f"{path}: the columns {', '.join(used)} have unequal numbers of rows, or none; fill them")
    place = _places(path, rows.pop())
    refuse_gaps(used["time_s"], used, place=place)
    if load is not None and np.any(used[load] < 0):
        at = place(int(np.argmax(used[load] < 0)))
        raise InputError(f"{at}: {load} is negative; a load opposes the motion, write its size")
    breakpoints = Breakpoints(
        time=tuple(used["time_s"].tolist()),
        speed=tuple((used[found[0]] * UNITS["speed"]["rpm"]).tolist()),
        load=tuple(used[load].tolist()) if load else None,
        held=(True,) * used["time_s"].size if load else None,
    )
    return breakpoints, SPEEDS[found[0]]


def _columns(path: Path) -> Mapping[str, NDArray[np.float64]]:
    if not path.is_file():
        raise InputError(f"{path}: there is no such file of a profile; check the path")
    if path.suffix.lower() not in readers():
        raise InputError(
            f"{path}: the ending {path.suffix!r} is no known table format; readable are {', '.join(readers())}"
        )
    return readers()[path.suffix.lower()](path).columns


def _places(path: Path, rows: int) -> Callable[[int], str]:
    """Return the function that names a row in messages: file and line of a text, file and row of other formats."""
    if path.suffix.lower() not in TEXTS:
        return lambda row: f"{path}: row {row + 1}"
    text = path.read_text(encoding="utf-8", errors="replace").splitlines()
    filled = [line for line, written in enumerate(text, start=1) if written.strip()][-rows:]
    return lambda row: f"{path}:{filled[row]}"
