"""Time stamps in text, converted to seconds from the first one of the file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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
_STAMP = re.compile(rf"(?:{_DATE}(?:(?:[T_;,]|\s)\s*(?:{_CLOCK}|{_COMPACT_CLOCK}))?)\s*")
_ONE_NUMBER = re.compile(
    r"((?:19[7-9]|20[0-9])[0-9](?:0[1-9]|1[0-2])(?:0[1-9]|[12][0-9]|3[01]))((?:[01][0-9]|2[0-3])[0-5][0-9][0-5][0-9])"
    r"[.,]?([0-9]{0,9})"
)
_BARE_CLOCK = re.compile(rf"{_CLOCK}\s*")
_DAY, _SECOND = 86_400 * 10**9, 10**9  # [ns]


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
    """

    words: str
    has_date: bool
    has_clock: bool
    month_first: bool
    origin: int = 0


def is_written_date(cell: str) -> bool:
    """Return whether a number is a date and a time of day of the years 1970 to 2099: 20240305101159.25."""
    return _ONE_NUMBER.fullmatch(cell) is not None


def with_signs(cell: str) -> str:
    """Return a date that is written as one number with T and a point: 20240305T101159.25; others as they are."""
    match = _ONE_NUMBER.fullmatch(cell)
    return cell if match is None else f"{match[1]}T{match[2]}" + (f".{match[3]}" if match[3] else "")


def is_stamp(cell: str) -> bool:
    """Return whether a cell is a date, a time of day or both; a plain number is none."""
    return (":" in cell and _BARE_CLOCK.fullmatch(cell) is not None) or _STAMP.fullmatch(cell) is not None


def stamp_form(cells: Sequence[str]) -> StampForm | None:
    """Return the form of all the stamps in ``cells``; None where they differ or cannot be read.

    Day first or month first is decided by a number above 12, else by the order in which the days lie closest
    together, else it is day first for dots and month first for slashes, which does not matter within one day.
    """
    found = [_BARE_CLOCK.fullmatch(cell) or _STAMP.fullmatch(cell) for cell in cells]
    matches = [match.groupdict() for match in found if match is not None]
    if not matches or len(matches) < len(found):
        return None
    dates = {"year" in one and any(one.get(key) for key in ("year", "compact", "one", "before")) for one in matches}
    clocks = {any(one.get(key) for key in ("minute", "digits")) for one in matches}
    if len(dates) > 1 or len(clocks) > 1:
        return None
    has_date, has_clock = dates.pop(), clocks.pop()
    minutes_only = has_clock and not has_date and all(one["second"] is None for one in matches)
    if minutes_only and all(one["part"] is None for one in matches):
        return None  # 10:11 may be hours and minutes, or minutes and seconds
    month_first = has_date and _month_first(matches)
    form = StampForm(words=_words(matches[0], month_first=month_first), has_date=has_date, has_clock=has_clock,
                     month_first=month_first)  # fmt: skip
    first = _nanoseconds(cells[0], form)
    return None if first is None else StampForm(words=form.words, has_date=has_date, has_clock=has_clock,
                                                month_first=month_first, origin=first)  # fmt: skip


class Stamps:
    """Converts the stamps of one column, piece by piece.

    ``with_date`` states that another column holds the date, so that a time of day may begin anew at midnight.
    """

    def __init__(self, form: StampForm, *, with_date: bool = False) -> None:
        self._form = form
        self._is_dated = form.has_date or with_date
        self._last: float | None = None
        self._days = 0

    def seconds(self, cells: Sequence[str]) -> NDArray[np.float64]:
        """Return the seconds from the first stamp of the file, shape (cells,); NaN where a cell is empty.

        Raises
        ------
        ValueError
            With the number of the first cell that is no stamp of this form, and the cell.
        """
        quick = _converted_at_once(cells, self._form)
        times = np.array([self._one(number, cell) for number, cell in enumerate(cells)]) if quick is None else quick
        return times if self._is_dated else self._over_midnight(times)

    def _one(self, number: int, cell: str) -> float:
        if not cell:
            return float("nan")
        found = _nanoseconds(cell, self._form)
        if found is None:
            raise ValueError(number, cell)
        return (found - self._form.origin) / _SECOND

    def _over_midnight(self, times: NDArray[np.float64]) -> NDArray[np.float64]:
        """Add a day wherever the time of day falls by more than half a day."""
        if times.size == 0:
            return times
        falls = np.diff(times, prepend=times[0] if self._last is None else self._last) < -43_200
        days = self._days + np.cumsum(falls)
        self._last, self._days = float(times[-1]), int(days[-1])
        return times + 86_400.0 * days


def _month_first(matches: Sequence[dict[str, str | None]]) -> bool:
    pairs = [(int(one["one"] or 0), int(one["two"] or 0), int(one["late"] or 0)) for one in matches if one["one"]]
    if not pairs:
        return False
    if any(first > 12 for first, _, _ in pairs):
        return False
    if any(second > 12 for _, second, _ in pairs):
        return True
    by_day = {year * 372 + second * 31 + first for first, second, year in pairs}
    by_month = {year * 372 + first * 31 + second for first, second, year in pairs}
    spans = max(by_day) - min(by_day), max(by_month) - min(by_month)
    return spans[1] < spans[0] if spans[0] != spans[1] else matches[0]["sign"] == "/"


def _words(match: dict[str, str | None], *, month_first: bool) -> str:
    if match.get("year") or match.get("compact"):
        return "ISO 8601"
    if match.get("one"):
        return "month first" if month_first else "day first"
    return "with the name of the month" if match.get("before") else "times of day"


def _nanoseconds(cell: str, form: StampForm) -> int | None:
    """Return the time since 1970 or midnight [ns], None where the cell is no stamp of this form."""
    match = (_STAMP if form.has_date else _BARE_CLOCK).fullmatch(cell)
    if match is None:
        return None
    parts = match.groupdict()
    days = _days(parts, month_first=form.month_first) if form.has_date else 0
    clock = _clock(parts) if form.has_clock else 0
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


def _clock(parts: dict[str, str | None]) -> int | None:
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
    fine = int((part or "0").ljust(9, "0"))
    return ((60 * hour + minute - offset) * 60 + second) * _SECOND + fine


def _converted_at_once(cells: Sequence[str], form: StampForm) -> NDArray[np.float64] | None:
    """Return the seconds where all stamps have the same digits at the same places, else None.

    Only stamps with a year of four digits, or without a date, and with hours, minutes and seconds of 24 hours.
    """
    if len(cells) < 2 or any(not cell.isascii() for cell in (cells[0], cells[-1])):
        return None
    match = (_STAMP if form.has_date else _BARE_CLOCK).fullmatch(cells[0])
    parts = {} if match is None else match.groupdict()
    if (
        match is None
        or not parts.get("second")
        or parts["half"]
        or (form.has_date and _date_groups(parts, form) is None)
    ):
        return None
    try:
        text = np.array(cells, dtype="S")
    except UnicodeEncodeError:
        return None
    size = text.dtype.itemsize
    signs = np.frombuffer(text.tobytes(), dtype=np.uint8).reshape(len(cells), size)
    is_digit = (signs[0] >= ord("0")) & (signs[0] <= ord("9"))
    moving = is_digit.copy()
    if parts["zone"]:
        moving[match.start("zone") :] = False  # a zone that changes is read one by one
    if len(cells[0]) != size or not np.array_equal(
        np.broadcast_to(signs[0][~moving], (len(cells), int((~moving).sum()))), signs[:, ~moving]
    ):
        return None
    digits = signs[:, moving]
    if np.any((digits < ord("0")) | (digits > ord("9"))):
        return None
    return _assembled(cells[0], signs, match, text, form)


def _date_groups(parts: dict[str, str | None], form: StampForm) -> tuple[str, str, str] | None:
    """Return the groups of year, month and day; None for dates that are read one by one."""
    if parts.get("year"):
        return "year", "month", "day"
    if len(parts.get("late") or "") < 4:
        return None
    return ("late", "one", "two") if form.month_first else ("late", "two", "one")


def _assembled(
    first: str, signs: NDArray[np.uint8], match: re.Match[str], text: NDArray[np.bytes_], form: StampForm
) -> NDArray[np.float64] | None:
    def number(name: str) -> NDArray[np.int64]:
        low, high = match.span(name)
        weights = 10 ** np.arange(high - low - 1, -1, -1, dtype=np.int64)
        return (signs[:, low:high].astype(np.int64) - ord("0")) @ weights if low >= 0 else np.zeros(len(text), np.int64)

    minute, second = number("minute"), number("second")
    if minute.max(initial=0) > 59 or second.max(initial=0) > 60:
        return None
    clock = (number("hour") * 60 + minute) * 60 + second
    low, high = match.span("part")
    fine = number("part") * 10 ** (9 - (high - low)) if low >= 0 else np.zeros(len(text), np.int64)
    days = np.zeros(len(text), np.int64)
    if form.has_date:
        year, month, day = (number(group) for group in _date_groups(match.groupdict(), form) or ())
        if month.min() < 1 or month.max() > 12 or day.min() < 1:
            return None
        months = (year - 1970) * 12 + month - 1
        whole_days = months.astype("datetime64[M]").astype("datetime64[D]") + (day - 1)
        if not np.array_equal(whole_days.astype("datetime64[M]").astype(np.int64), months):
            return None  # a 31st of June
        days = whole_days.astype(np.int64)
    start = _nanoseconds(first, form)
    if start is None:
        return None
    whole = (days * 86_400 + clock) * _SECOND + fine
    return np.asarray((whole - whole[0] + (start - form.origin)) / _SECOND, dtype=np.float64)
