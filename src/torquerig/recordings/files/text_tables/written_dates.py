"""Dates and times of day that are written as one number."""

from __future__ import annotations

import re

_ONE_NUMBER = re.compile(
    r"((?:19[7-9]|20[0-9])[0-9](?:0[1-9]|1[0-2])(?:0[1-9]|[12][0-9]|3[01]))((?:[01][0-9]|2[0-3])[0-5][0-9][0-5][0-9])"
    r"[.,]?([0-9]{0,9})"
)


def is_written_date(cell: str) -> bool:
    """Return whether a number is a date and a time of day of the years 1970 to 2099: 20240305101159.25."""
    return _ONE_NUMBER.fullmatch(cell) is not None


def with_signs(cell: str) -> str:
    """Return a date that is written as one number with T and a point: 20240305T101159.25; others as they are."""
    match = _ONE_NUMBER.fullmatch(cell)
    return cell if match is None else f"{match[1]}T{match[2]}" + (f".{match[3]}" if match[3] else "")
