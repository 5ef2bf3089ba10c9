"""One time stamp as it is written: its parts, and its time in nanoseconds."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

_MONTHS = ("jan", "feb", "mar|mär", "apr", "may|mai", "jun", "jul", "aug", "sep", "oct|okt", "nov", "dec|dez")
_DATE = (
    r"(?:(?P<year>[0-9]{4})[-/.](?P<month>[0-9]{1,2})[-/.](?P<day>[0-9]{1,2})"
    r"|(?P<compact>(?:19|20)[0-9]{6})(?=[T _][0-9])"
    r"|(?P<one>[0-9]{1,2})(?P<sign>[./-])(?P<two>[0-9]{1,2})(?P=sign)(?P<late>[0-9]{4}|[0-9]{2})"
    r"|(?P<before>[0-9]{1,2})[-. ]+(?P<word>[A-Za-zä]{3,9})\.?[-, ]+(?P<after>[0-9]{4}|[0-9]{2}))"
)
_CLOCK = (
    r"(?P<hour>[0-9]{1,3}):(?P<minute>[0-9]{2})(?::(?P<second>[0-9]{2}))?(?:[.,:](?P<part>[0-9]{1,9}))?"
    r"(?:\s*(?P<half>[AaPp])\.?[Mm]\.?)?(?:\s*(?P<zone>Z|UTC|GMT|[+-][0-9]{2}:?[0-9]{2}))?"
)
_COMPACT_CLOCK = r"(?P<digits>[0-9]{6})(?:[.,](?P<fine>[0-9]{1,9}))?(?P<place>Z)?"
STAMP = re.compile(rf"(?:{_DATE}(?:(?:[T_;,]|\s)\s*(?:{_CLOCK}|{_COMPACT_CLOCK}))?)\s*")
BARE_CLOCK = re.compile(rf"{_CLOCK}\s*")
_DAY, SECOND = 86_400 * 10**9, 10**9  # [ns]


@dataclass(frozen=True, kw_only=True)
class StampForm:
    """How the stamps of a column are written.

    Parameters
    ----------
    words : str
        For a note: ``"ISO 8601"``, ``"day first"``, ``"times of day"``.
    has_date, has_clock : bool
    month_first : bool
        Of dates such as 05/12/2021.
    origin : int
        The first stamp [ns]; the seconds count from it.
    first : str
        The first stamp as written.
    is_undecided : bool
        Whether the first stamps fit day first and month first equally; the first change of the date decides.
    counted : int
        Where the last part is no decimal fraction but a count, as in 10:11:12:5 for 5 ms: its digits, 3 for
        milliseconds; else 0.
    """

    words: str
    has_date: bool
    has_clock: bool
    month_first: bool
    origin: int = 0
    first: str = ""
    is_undecided: bool = False
    counted: int = 0


def is_stamp(cell: str) -> bool:
    """Return whether a cell is a date, a time of day or both; a plain number is none."""
    return (":" in cell and BARE_CLOCK.fullmatch(cell) is not None) or STAMP.fullmatch(cell) is not None


def nanoseconds(cell: str, form: StampForm) -> int | None:
    """Return the time since 1970 or midnight [ns], None where the cell is no stamp of this form."""
    match = (STAMP if form.has_date else BARE_CLOCK).fullmatch(cell)
    if match is None:
        return None
    parts = match.groupdict()
    days = _days(parts, month_first=form.month_first) if form.has_date else 0
    clock = _clock(parts, form.counted) if form.has_clock else 0
    return None if days is None or clock is None else days * _DAY + clock


def _days(parts: dict[str, str | None], *, month_first: bool) -> int | None:
    year: str | None
    month: str | None
    day: str | None
    if parts["year"]:
        year, month, day = parts["year"], parts["month"], parts["day"]
    elif parts["compact"]:
        year, month, day = parts["compact"][:4], parts["compact"][4:6], parts["compact"][6:]
    elif parts["one"]:
        year, month, day = parts["late"], parts["two"], parts["one"]
        month, day = (day, month) if month_first else (month, day)
    else:
        word = (parts["word"] or "")[:3].lower()
        number = next((count for count, names in enumerate(_MONTHS, 1) if word in names.split("|")), 0)
        year, month, day = parts["after"], str(number), parts["before"]
    whole = int(year or 0) + (2000 if len(year or "") == 2 else 0)
    try:
        return int((np.datetime64(f"{whole:04d}-{int(month or 0):02d}-{int(day or 0):02d}", "D")).astype(np.int64))
    except ValueError:
        return None


def _clock(parts: dict[str, str | None], counted: int) -> int | None:
    if parts.get("digits"):
        text, part, zone, half = parts["digits"] or "", parts["fine"], parts["place"], None
        hour, minute, second = int(text[:2]), int(text[2:4]), int(text[4:])
    elif parts["second"] is None and parts["part"] is not None:
        # Excel shows 00:01.5 for minutes and seconds
        hour, minute, second = 0, int(parts["hour"] or 0), int(parts["minute"] or 0)
        part, zone, half = parts["part"], parts["zone"], parts["half"]
    else:
        hour, minute, second = (int(parts[key] or 0) for key in ("hour", "minute", "second"))
        part, zone, half = parts["part"], parts["zone"], parts["half"]
    if (minute > 59 and hour) or second > 60:
        return None
    if half:
        hour = hour % 12 + (12 if half in "Pp" else 0)
    offset = 0
    if zone and zone[0] in "+-":
        offset = (60 * int(zone[1:3]) + int(zone[-2:])) * (-1 if zone[0] == "-" else 1)
    fine = int((part or "0").rjust(counted, "0").ljust(9, "0"))
    return ((60 * hour + minute - offset) * 60 + second) * SECOND + fine
