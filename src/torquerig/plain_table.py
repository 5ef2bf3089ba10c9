"""Aligned columns and wrapped sentences for the terminal: without colours."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import floor, isfinite, log10
from textwrap import fill

import numpy as np

WIDTH = 120
_MOST_DECIMALS = 15  # a double has no more


def grid(rows: Sequence[Sequence[str]], *, right: Collection[int] | None = None) -> str:
    """Return rows as aligned columns, the first row ruled off.

    Parameters
    ----------
    rows : sequence of rows of equal length
    right : collection of int, optional
        Columns to set to the right; those that hold only numbers when not given.
    """
    columns = range(len(rows[0]))
    widths = [max(len(row[place]) for row in rows) for place in columns]
    if right is None:
        right = [place for place in columns if _holds_numbers([row[place] for row in rows[1:]])]
    lines = [
        "  ".join(row[place].rjust(widths[place]) if place in right else row[place].ljust(widths[place])
                  for place in columns).rstrip()
        for row in rows
    ]  # fmt: skip
    return "\n".join([lines[0], "-" * max(len(line) for line in lines), *lines[1:]])


def wrapped(text: str, *, first: str = "", rest: str = "  ") -> str:
    """Return one paragraph at most ``WIDTH`` wide, its first and its other lines set in as stated."""
    return fill(
        text, WIDTH, initial_indent=first, subsequent_indent=rest, break_long_words=False, break_on_hyphens=False
    )


def fixed(value: float, *, scale: float, digits: int) -> str:
    """Return a number with the decimals at which one of the size ``scale`` has ``digits`` significant digits.

    So all numbers of a table end at the same place, and a rig of micronewton metres shows as many digits as one of
    kilonewton metres.
    """
    places = digits - 1 - floor(log10(abs(scale))) if scale and isfinite(scale) else digits - 1
    return f"{value:.{min(max(places, 0), _MOST_DECIMALS)}f}"


def rms_size(values: np.ndarray) -> float:
    """Return the root mean square of ``values``, shape (samples,), as the size of their quantity; NaN left out."""
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(np.square(known)))) if known.size else 0.0


def cut(text: str, width: int) -> str:
    """Return ``text``, shortened with an ellipsis where it is longer than ``width``."""
    return text if len(text) <= width else f"{text[: width - 1]}…"


def _holds_numbers(cells: Sequence[str]) -> bool:
    """Whether there is a number and nothing but numbers, ``-`` and ``?``."""
    plain = [cell.removesuffix("%").strip() for cell in cells if cell not in ("", "-", "?")]
    try:
        return bool([float(cell) for cell in plain])
    except ValueError:
        return False
