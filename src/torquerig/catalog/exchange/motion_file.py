"""The motion table of a section of IDTA 02021: columns as ``Time [s]``, separated by semicolons."""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from itertools import pairwise
from math import isfinite, pi

from torquerig.errors import InputError, UnitError
from torquerig.units import parse_quantity

UNITS = {"Time": "s", "AngularVelocity": "rad/s", "LoadTorque": "N*m", "FrictionTorque": "N*m"}
MOST_ROWS = 1_000_000
STEP = 1e-3  # [1] of the first step of a section: the time in which speed or load change to those of that section
_COLUMN = re.compile(r"^\s*(\w+)\s*(?:\[(.*)\])?\s*$")


@dataclass(frozen=True)
class Motion:
    """A motion of the load: times [s], speeds [rad/s], and torques that oppose the motion [N m]."""

    time: tuple[float, ...]
    speed: tuple[float, ...]
    torque: tuple[float, ...]

    def table(self) -> str:
        """Return the motion as the profile table that ``duty``, ``size`` and ``simulate`` read."""
        rows = [
            f"{t:.9g},{w * 30 / pi:.9g},{m:.9g}" for t, w, m in zip(self.time, self.speed, self.torque, strict=True)
        ]
        return "\n".join(["time_s,output_speed_rpm,torque_Nm", *rows, ""])


def read_motion(content: bytes, where: str, constants: Mapping[str, float]) -> Motion:
    """Return the motion of one table; ``constants`` are the load and friction torque that hold for all of it [N m].

    The template counts a load torque positive in the direction of rising angle, so that a load which opposes a
    positive speed is negative. Here it is the size of what opposes, plus friction.

    Raises
    ------
    InputError
        Where a column or unit is missing, a number is none, the time does not rise, or the load drives the motion.
    """
    try:
        rows = list(csv.reader(StringIO(content.decode("utf-8-sig")), delimiter=";"))
    except (UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"{where}: is no CSV text in UTF-8 ({error}); export it again") from None
    rows = [row for row in rows if any(cell.strip() for cell in row)]
    if len(rows) < 3 or len(rows) > MOST_ROWS:
        raise InputError(f"{where}: has {max(len(rows) - 1, 0)} rows; 2 to {MOST_ROWS} are needed")
    columns = _columns(rows, where)
    time, speed = columns["Time"], columns["AngularVelocity"]
    load, friction = (
        columns.get(key, [constants.get(key, 0.0)] * len(time)) for key in ("LoadTorque", "FrictionTorque")
    )
    for number, (before, after) in enumerate(pairwise(time), start=3):
        if after <= before:
            raise InputError(f"{where}:{number}: the time does not rise; sort the rows")
    return Motion(tuple(time), tuple(speed), tuple(_opposing(speed, load, friction, where)))


def _columns(rows: Sequence[Sequence[str]], where: str) -> dict[str, list[float]]:
    found: dict[str, list[float]] = {}
    for place, head in enumerate(rows[0]):
        match = _COLUMN.match(head)
        if match is None or match[1] not in UNITS:
            continue
        factor = _factor(match[1], match[2], where)
        found[match[1]] = [
            _cell(row, place, f"{where}:{number}", match[1]) * factor for number, row in enumerate(rows[1:], 2)
        ]
    missing = [key for key in ("Time", "AngularVelocity") if key not in found]
    if missing:
        raise InputError(
            f"{where}:1: the column {missing[0]} is missing; write it as '{missing[0]} [{UNITS[missing[0]]}]'"
        )
    return found


def _factor(name: str, unit: str | None, where: str) -> float:
    if not unit:
        raise InputError(f"{where}:1: the column {name} has no unit; write '{name} [{UNITS[name]}]'")
    try:
        return parse_quantity(f"1 {unit}", UNITS[name])
    except UnitError as error:
        raise InputError(f"{where}:1: the column {name}: {error}") from None


def _cell(row: Sequence[str], place: int, where: str, name: str) -> float:
    text = row[place].strip() if place < len(row) else ""
    try:
        number = float(text)
    except ValueError:
        number = float("nan")
    if not isfinite(number):
        raise InputError(f"{where}: {name} is {text!r}, no number with a decimal point; correct it")
    return number


def _opposing(speed: Sequence[float], load: Sequence[float], friction: Sequence[float], where: str) -> list[float]:
    """Return the torque against the motion; at rest the direction of the motion before or after counts."""
    directions = _directions(speed)
    found = []
    for number, (way, torque, rub) in enumerate(zip(directions, load, friction, strict=True), start=2):
        against = abs(rub) - way * torque
        if against < 0:
            raise InputError(
                f"{where}:{number}: the load drives the motion with {-against:.4g} N*m, which a profile here does not "
                "take; a load that opposes a positive speed is negative in IDTA 02021"
            )
        found.append(against)
    return found


def _directions(speed: Sequence[float]) -> list[int]:
    ways = [(one > 0) - (one < 0) for one in speed]
    first = next((way for way in ways if way), 1)
    held, found = first, []
    for way in ways:
        held = way or held
        found.append(held)
    return found


def motion_file(motion: Motion) -> str:
    """Return a motion of the load as the table of a section of IDTA 02021, with angle and acceleration.

    A step, which is a time that occurs twice, takes a thousandth of the interval after it.
    """
    time = _rising(motion.time)
    heads = ("Time [s]", "AngularPosition [rad]", "AngularVelocity [rad/s]", "AngularAcceleration [rad/s²]")
    angle, rows = 0.0, [";".join((*heads, "LoadTorque [Nm]"))]
    for at, (way, now, speed) in enumerate(zip(_directions(motion.speed), time, motion.speed, strict=True)):
        after = min(at + 1, len(time) - 1)
        before = max(at - 1, 0)
        angle += 0.5 * (motion.speed[before] + speed) * (now - time[before])
        start = at if after > at else before
        slope = (motion.speed[start + 1] - motion.speed[start]) / (time[start + 1] - time[start])
        numbers = (now, angle, speed, slope, -way * motion.torque[at])
        rows.append(";".join(f"{one:.9g}" for one in numbers))
    return "\n".join([*rows, ""])


def _rising(time: Sequence[float]) -> list[float]:
    found = list(time)
    for at in range(1, len(found)):
        if found[at] <= found[at - 1]:
            later = next((one for one in time[at:] if one > found[at - 1]), found[at - 1] + 1.0)
            found[at] = found[at - 1] + STEP * (later - found[at - 1])
    return found


def joined(motions: Sequence[Motion]) -> Motion | None:
    """Return sections one after the other; None where there are none. Each starts its time anew."""
    time: list[float] = []
    speed: list[float] = []
    torque: list[float] = []
    for motion in motions:
        start = time[-1] if time else 0.0
        times = [start + one - motion.time[0] for one in motion.time]
        first = 0
        if time:
            same = speed[-1] == motion.speed[0] and torque[-1] == motion.torque[0]
            first = 1 if same else 0
            times[0] += STEP * (times[1] - times[0])
        time += times[first:]
        speed += motion.speed[first:]
        torque += motion.torque[first:]
    return Motion(tuple(time), tuple(speed), tuple(torque)) if time else None
