"""The columns that hold the times of the samples."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from torquerig.recordings.names.channel_units import unit_meanings
from torquerig.recordings.names.header import split_header
from torquerig.recordings.names.words import TIME_WORDS, words_of
from torquerig.units import Meaning

# the first of these that a table has is its time
_EXACT = ("time_s", "time", "t", "x_value", "zeit", "timestamp", "time stamp", "zeitstempel", "elapsed time", "tout")
_CLOCKS = {"millis": "ms", "micros": "us", "msec": "ms", "usec": "us"}  # names of counters of microcontrollers
# words that make a column of time something else than the time of the sample
_NOT = ("constant", "konstante", "cycle", "zyklus", "delay", "const", "loop", "exposure", "response", "lap", "runde")


# words of a signal's header that its times do not have: "Amplitude - Torque" and "Time - Torque"
_FILLERS = ("amplitude", "value", "values", "data", "wert", "werte", "x", "y")
# doubled names get a number
_NUMBERED = re.compile(r"(t|x_value)[ _]?\d+")


@dataclass(frozen=True)
class TimeColumn:
    """A column of times: its name, its unit, the unit's length [s], and whether the file states the unit."""

    name: str
    unit: str
    seconds: float
    stated: bool


def time_column(names: Iterable[str], units: Mapping[str, str] | None = None) -> TimeColumn | None:
    """Return the column of times among ``names``, or None; of several the one with the plainest name.

    A name such as ``time``, ``Zeit [ms]`` or ``t``, whose unit is one of time or is not stated; then it is seconds.
    ``units`` are those that the file states by name.
    """
    exact: dict[str, TimeColumn] = {}
    worded: list[TimeColumn] = []
    for cell in names:
        one = _of_time(cell, units)
        if one is None:
            continue
        name, _ = split_header(cell)
        for key in (cell.strip().lower(), name.strip().lower()):
            exact.setdefault(key, one)
        if _is_time(name) or _unit_as_name(name) is not None:
            worded.append(one)
    plainest = next((exact[key] for key in _EXACT if key in exact), None)
    return plainest or next(iter(worded), None)


def time_columns(names: Iterable[str], units: Mapping[str, str] | None = None) -> list[TimeColumn]:
    """Return all columns of times among ``names``, in their order, as far as names and units show.

    In addition to those of :func:`time_column`: ``Time_2`` and ``t2``, and ``t_torque`` where there is a ``torque``.
    """
    cells = list(names)
    own = {cell: words_without_time(cell) for cell in cells}
    signals = {own[cell] for cell in cells if not _is_short_time(cell)}
    found = []
    for cell in cells:
        one = _of_time(cell, units)
        if one is None:
            continue
        name, _ = split_header(cell)
        is_plain = name.strip().lower() in _EXACT or cell.strip().lower() in _EXACT
        is_numbered = _NUMBERED.fullmatch(name.strip().lower()) is not None
        is_paired = _is_short_time(cell) and bool(own[cell]) and own[cell] in signals
        if is_plain or is_numbered or is_paired or _is_time(name) or _unit_as_name(name) is not None:
            found.append(one)
    return found


def words_without_time(cell: str) -> tuple[str, ...]:
    """Return what a header says beyond time and unit: of ``Data1_time_Torque`` and ``Data1_Torque`` the same words."""
    name, _ = split_header(cell)
    return tuple(word for word in words_of(name) if word not in (*TIME_WORDS, "t", *_FILLERS))


def _of_time(cell: str, units: Mapping[str, str] | None) -> TimeColumn | None:
    """Return a column whose unit is one of time or not stated as a column of times, whatever its name."""
    name, written = split_header(cell)
    written = (units or {}).get(cell) or written
    own = None if written else _unit_as_name(name)
    written = written or own
    if written is None:
        return TimeColumn(cell, "s", 1.0, stated=False)
    found = _meanings(written, is_time=own is not None or _is_time(name))
    return TimeColumn(cell, found["time"].symbol, found["time"].factor, stated=True) if "time" in found else None


def _is_time(name: str) -> bool:
    words = words_of(name)
    return any(word in TIME_WORDS for word in words) and not any(word in _NOT for word in words)


def _unit_as_name(name: str) -> str | None:
    """Return the name itself where it is a unit of time of two letters or more (``ms``, ``millis``), else None."""
    found = _meanings(name, is_time=True)
    return name if len(name) > 1 and "time" in found else None


def _meanings(unit: str, *, is_time: bool) -> dict[str, Meaning]:
    """Return what a unit may mean by kind; of a column of times in lower case too (``TIME(MS)``)."""
    found = {one.kind: one for one in unit_meanings(unit)}
    if is_time and "time" not in found:
        found |= {one.kind: one for one in unit_meanings(_CLOCKS.get(unit.lower(), unit.lower())) if one.kind == "time"}
    return found


def _is_short_time(cell: str) -> bool:
    # a capital T is a temperature
    parts = split_header(cell)[0].split("_")
    return len(parts) > 1 and "t" in (parts[0], parts[-1])
