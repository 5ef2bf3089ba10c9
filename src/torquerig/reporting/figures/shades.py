"""Colour scales of cells that a colour-blind reader can tell apart: orange is worse, blue is better."""

from __future__ import annotations

WORSE, BETTER = (245, 184, 115), (125, 181, 224)
"""sRGB, 0 to 255: pale tones of orange and blue of Okabe and Ito; black text on both has a contrast above 9."""
GOOD_IS_LOW, GOOD_IS_HIGH = "low", "high"
SHARES = {"load": "#b8c4cf", "cogging": "#e69f00", "electrical": "#0072b2", "mechanical": "#5b4a8a"}
"""The colour of each share of a reading."""
MARKS = {"+": "#cfe3f4", "-": "#fbdcbc", "?": "#fdf0c4", "!": "#e6d9f2", "S": "#eceff1"}
"""Background of the signs of the matrices."""


def shade(value: float, low: float, high: float, *, scale: str) -> str:
    """Return the CSS of a cell whose background shows ``value`` between ``low`` and ``high``, white in the middle.

    ``scale`` is ``GOOD_IS_LOW`` or ``GOOD_IS_HIGH``. ``shadeOf`` in matrix_tables.js is the same.
    """
    place = min(max((value - low) / (high - low), 0.0), 1.0) if high > low else 0.5
    place = 1 - place if scale == GOOD_IS_LOW else place
    end, share = (WORSE, 1 - 2 * place) if place < 0.5 else (BETTER, 2 * place - 1)
    parts = (round(255 + share * (part - 255)) for part in end)
    return f"background:#{''.join(f'{part:02x}' for part in parts)};color:#000"


def mark_style(mark: str) -> str:
    """Return the CSS of a cell with a sign in it."""
    return f"background:{MARKS[mark]};color:#000" if mark in MARKS else ""
