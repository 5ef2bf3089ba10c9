"""The column that holds the times of the samples."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from torquerig.recordings.names.channel_units import unit_meanings
from torquerig.recordings.names.header import split_header
from torquerig.recordings.names.words import TIME_WORDS, words_of
from torquerig.units import Meaning

# the first of these that a table has is its time
_EXACT = ("time_s", "time", "t", "x_value", "zeit", "timestamp", "time stamp", "zeitstempel", "elapsed time")
_CLOCKS = {"millis": "ms", "micros": "us", "msec": "ms", "usec": "us"}  # names of counters of microcontrollers
# words that make a column of time something else than the time of the sample
_NOT = ("constant", "konstante", "cycle", "zyklus", "delay", "const", "loop", "exposure", "response")


@dataclass(frozen=True)
class TimeColumn:
    """A column of times: its name, its unit, the unit's length [s], and whether the file states the unit."""

    name: str
    unit: str
    seconds: float
    stated: bool


def time_column(names: Iterable[str], units: Mapping[str, str] | None = None) -> TimeColumn | None:
    """Return the column of times among ``names``, or None.

    A name such as ``time``, ``Zeit [ms]`` or ``t``, whose unit is one of time or is not stated; then it is seconds.
    ``units`` are those that the file states by name.
    """
    candidates: dict[str, TimeColumn] = {}
    worded: list[TimeColumn] = []
    for cell in names:
        name, written = split_header(cell)
        written = (units or {}).get(cell) or written
        own = None if written else _unit_as_name(name)
        written = written or own
        found = None if written is None else _meanings(written, is_time=own is not None or _is_time(name))
        if found is not None and "time" not in found:
            continue
        one = TimeColumn(cell, "s" if found is None else found["time"].symbol,
                         1.0 if found is None else found["time"].factor, found is not None)  # fmt: skip
        for key in (cell.strip().lower(), name.strip().lower()):
            candidates.setdefault(key, one)
        if _is_time(name) or (found is not None and written == name):
            worded.append(one)
    exact = next((candidates[key] for key in _EXACT if key in candidates), None)
    return exact or next(iter(worded), None)


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
