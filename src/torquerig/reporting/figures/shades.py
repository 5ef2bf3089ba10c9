"""Colour scales: a background for each value, with black or white text."""

from __future__ import annotations

from matplotlib import colormaps
from matplotlib.colors import Normalize, to_hex

GOOD_IS_LOW = "RdYlGn_r"
GOOD_IS_HIGH = "RdYlGn"
MARKS = {"+": "#d5ecd4", "-": "#f6cfca", "?": "#fdf0c4", "!": "#f9dcb0", "S": "#eceff1"}
"""Background of the signs of the matrices."""


def shade(value: float, low: float, high: float, *, scale: str) -> str:
    """Return the CSS of a cell whose background shows ``value`` between ``low`` and ``high``."""
    place = Normalize(low, high, clip=True)(value) if high > low else 0.5
    # paled, so that the text stays legible in print too
    red, green, blue, _ = colormaps[scale](float(place))
    colour = (0.35 + 0.65 * red, 0.35 + 0.65 * green, 0.35 + 0.65 * blue)
    return f"background:{to_hex(colour)};color:{readable_on(colour)}"


def readable_on(colour: tuple[float, float, float]) -> str:
    """Return black or white, whichever contrasts more with an sRGB colour in 0..1 (WCAG 2.2, relative luminance)."""
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in colour]
    luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    return "#000" if (luminance + 0.05) / 0.05 >= 1.05 / (luminance + 0.05) else "#fff"


def mark_style(mark: str) -> str:
    """Return the CSS of a cell with a sign in it."""
    return f"background:{MARKS[mark]};color:#000" if mark in MARKS else ""
