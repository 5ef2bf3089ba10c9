"""The points of a duty cycle or a table in a sidecar, read and written."""

from __future__ import annotations

from math import pi
from typing import Any

from torquerig.document import Document
from torquerig.errors import InputError
from torquerig.recordings.files.sidecar_schema import WrittenRun
from torquerig.recordings.profiles.breakpoints import Breakpoints
from torquerig.recordings.profiles.tabulated import Tabulated
from torquerig.recordings.run import Run
from torquerig.units import UNITS

RPM = UNITS["speed"]["rpm"]


def read_set_point(document: Document, written: WrittenRun) -> Tabulated | None:
    """Return the profile that ``run.set_point`` states, or None; InputError where its lists are inconsistent."""
    points = written.set_point
    if points is None:
        return None
    place = document.place(("run", "set_point"))
    if written.profile not in ("duty_cycle", "csv"):
        raise InputError(
            f"{place}: the profile {written.profile} takes no points; remove set_point, or write profile: csv"
        )
    lengths = {len(points.time_s), len(points.speed_rpm), len(points.load_Nm or points.time_s)}
    if lengths != {len(points.time_s)} or len(points.time_s) < 2:
        raise InputError(f"{place}: its lists need the same number of points, two or more; complete them")
    falling = any(later < earlier for earlier, later in zip(points.time_s, points.time_s[1:], strict=False))
    if falling or points.time_s[0] != 0 or points.time_s[-1] == 0:
        raise InputError(f"{place}: time_s starts at 0 and does not fall; put the points in order")
    if points.repeats is not None and points.repeats < 1:
        raise InputError(f"{place}: repeats is {points.repeats}; write 1 or more, or null for without end")
    rows = Breakpoints(
        time=tuple(points.time_s),
        speed=tuple(RPM * speed for speed in points.speed_rpm),
        load=None if points.load_Nm is None else tuple(points.load_Nm),
    )
    return Tabulated(rows=rows, repeats=points.repeats, name=written.profile)


def set_point_entry(run: Run) -> dict[str, Any] | None:
    """Return the sidecar entry of a tabulated profile, else None."""
    if not isinstance(run.set_points, Tabulated):
        return None
    rows = run.set_points.rows
    entry: dict[str, Any] = {
        "time_s": list(rows.time),
        "speed_rpm": [float(f"{speed * 30 / pi:.15g}") for speed in rows.speed],
    }
    if rows.load is not None:
        entry["load_Nm"] = list(rows.load)
    return {**entry, "repeats": run.set_points.repeats}
