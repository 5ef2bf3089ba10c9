"""Time stamps in text, converted to seconds from the first one of the file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.text_tables.stamp_parts import BARE_CLOCK, SECOND, STAMP, StampForm, nanoseconds


def stamp_form(cells: Sequence[str]) -> StampForm | None:
    """Return the form of all the stamps in ``cells``; None where they differ or cannot be read.

    Day first or month first is decided by a number above 12, else by the order in which the days lie closest
    together, else it is day first for dots and month first for slashes, which does not matter within one day.
    """
    found = [BARE_CLOCK.fullmatch(cell) or STAMP.fullmatch(cell) for cell in cells]
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
    month_first, is_undecided = _order_of_days(matches) if has_date else (False, False)
    form = StampForm(words=_words(matches[0], month_first=month_first, is_undecided=is_undecided), has_date=has_date,
                     has_clock=has_clock, month_first=month_first, first=cells[0],
                     is_undecided=is_undecided)  # fmt: skip
    form = replace(form, counted=_counted_digits(cells, [one.get("part") for one in matches], form))
    first = nanoseconds(cells[0], form)
    return None if first is None else replace(form, origin=first)


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
        times = self._by_the_order_that_rises(cells) if self._form.is_undecided else _converted(cells, self._form)
        if self._is_dated:
            self._last = float(times[-1]) if times.size else self._last
            return times
        return self._over_midnight(times)

    def _by_the_order_that_rises(self, cells: Sequence[str]) -> NDArray[np.float64]:
        """Return the seconds with day or month first, whichever makes the smaller steps; the choice stays."""
        found: list[tuple[float, StampForm, NDArray[np.float64]]] = []
        fault: ValueError | None = None
        for month_first in (self._form.month_first, not self._form.month_first):
            form = replace(self._form, month_first=month_first, is_undecided=False)
            origin = nanoseconds(form.first, form)
            form = replace(form, origin=origin or 0)
            try:
                times = _converted(cells, form)
            except ValueError as error:
                fault = fault or error
                continue
            steps = np.abs(np.diff(times, prepend=times[:1] if self._last is None else self._last))
            found.append((float(np.nanmax(steps, initial=0.0)), form, times))
        if not found and fault is not None:
            raise fault
        if len(found) < 2 or not np.array_equal(found[0][2], found[1][2], equal_nan=True):
            self._form = min(found, key=lambda one: one[0])[1]
        return min(found, key=lambda one: one[0])[2]

    def _over_midnight(self, times: NDArray[np.float64]) -> NDArray[np.float64]:
        """Add a day wherever the time of day falls by more than half a day."""
        if times.size == 0:
            return times
        falls = np.diff(times, prepend=times[0] if self._last is None else self._last) < -43_200
        days = self._days + np.cumsum(falls)
        self._last, self._days = float(times[-1]), int(days[-1])
        return times + 86_400.0 * days


def _converted(cells: Sequence[str], form: StampForm) -> NDArray[np.float64]:
    """Return the seconds of stamps of this form; ValueError as :meth:`Stamps.seconds`."""
    quick = None if form.counted else _converted_at_once(cells, form)
    return np.array([_one(number, cell, form) for number, cell in enumerate(cells)]) if quick is None else quick


def _one(number: int, cell: str, form: StampForm) -> float:
    if not cell:
        return float("nan")
    found = nanoseconds(cell, form)
    if found is None:
        raise ValueError(number, cell)
    return (found - form.origin) / SECOND


def _counted_digits(cells: Sequence[str], parts: Sequence[str | None], form: StampForm) -> int:
    """Return the digits of a count behind the seconds, 3 for milliseconds; 0 for a decimal fraction.

    A fraction may begin with a zero, a count of several digits may not. A fraction with fewer digits than others ends
    without a zero. Where neither is seen, the reading counts with which fewer times fall.
    """
    written = [part for part in parts if part]
    longest = max(map(len, written), default=0)
    if len({len(part) for part in written}) < 2 or any(part[0] == "0" and len(part) > 1 for part in written):
        return 0
    digits = next(one for one in (3, 6, 9) if longest <= one)
    if any(part[-1] == "0" and 1 < len(part) < longest for part in written):
        return digits
    falls = [int(np.sum(np.diff(_converted(cells, replace(form, counted=one))) < 0)) for one in (0, digits)]
    return digits if falls[1] < falls[0] else 0


def _order_of_days(matches: Sequence[dict[str, str | None]]) -> tuple[bool, bool]:
    """Return whether the month is first, and whether the stamps fit the other order equally."""
    pairs = [(int(one["one"] or 0), int(one["two"] or 0), int(one["late"] or 0)) for one in matches if one["one"]]
    if not pairs or any(first > 12 for first, _, _ in pairs):
        return False, False
    if any(second > 12 for _, second, _ in pairs):
        return True, False
    by_day = {year * 372 + second * 31 + first for first, second, year in pairs}
    by_month = {year * 372 + first * 31 + second for first, second, year in pairs}
    spans = max(by_day) - min(by_day), max(by_month) - min(by_month)
    if spans[0] == spans[1]:
        return matches[0]["sign"] == "/", matches[0]["sign"] != "."
    return spans[1] < spans[0], False


def _words(match: dict[str, str | None], *, month_first: bool, is_undecided: bool) -> str:
    if match.get("year") or match.get("compact"):
        return "ISO 8601"
    if is_undecided:
        return "day or month first, as the dates rise"
    if match.get("one"):
        return "month first" if month_first else "day first"
    return "with the name of the month" if match.get("before") else "times of day"


def _converted_at_once(cells: Sequence[str], form: StampForm) -> NDArray[np.float64] | None:
    """Return the seconds where all stamps have the same digits at the same places, else None.

    Only stamps with a year of four digits, or without a date, and with hours, minutes and seconds of 24 hours.
    """
    if len(cells) < 2 or any(not cell.isascii() for cell in (cells[0], cells[-1])):
        return None
    match = (STAMP if form.has_date else BARE_CLOCK).fullmatch(cells[0])
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
    start = nanoseconds(first, form)
    if start is None:
        return None
    whole = (days * 86_400 + clock) * SECOND + fine
    return np.asarray((whole - whole[0] + (start - form.origin)) / SECOND, dtype=np.float64)
