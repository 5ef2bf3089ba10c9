"""Tables of a page: caption, head, and cells with text, colour and link."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.metrics.figure import Figure


@dataclass(frozen=True, kw_only=True)
class Cell:
    """One cell of a table.

    Parameters
    ----------
    text : str
    style : str
        CSS of the cell, for example a colour of ``shades``.
    word : str
        CSS classes: ``number``, ``mark``, ``unknown``.
    title : str
        Tooltip of the cell, such as a source.
    link : str
        Target of the cell's link, such as ``#cell-1-2``.
    """

    text: str
    style: str = ""
    word: str = ""
    title: str = ""
    link: str = ""


@dataclass(frozen=True, kw_only=True)
class Table:
    """A table of a page; the first cell of each row is its heading.

    ``emphasised`` are the numbers of bold rows, such as the present drive and the winner.
    """

    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    emphasised: frozenset[int] = frozenset()
    note: str = ""


def words(*texts: str) -> tuple[Cell, ...]:
    """Return one cell per text."""
    return tuple(Cell(text=text) for text in texts)


def number(text: str, *, style: str = "", title: str = "") -> Cell:
    """Return a right-aligned cell; ``?`` is marked as unknown."""
    return Cell(text=text, style=style, word="number unknown" if text == "?" else "number", title=title)


def figure_cell(figure: Figure, *, style: str = "") -> Cell:
    """Return the cell of a figure, with its source and the missing value as tooltip."""
    missing = f"missing: {figure.missing}" if figure.missing else ""
    return number(figure_text(figure), style=style, title="; ".join(text for text in (figure.source, missing) if text))


def figure_text(figure: Figure) -> str:
    """Return a figure for a table: ``0.102 (0.094..0.117)``, ``340..1300`` or ``?``, never with an exponent."""
    if figure.unknown:
        return "?"
    interval = ""
    if figure.low is not None and figure.high is not None and figure.low < figure.high:
        low, high = plain(figure.low), plain(figure.high)
        interval = low if low == high else f"{low}..{high}"
    if figure.value is None:
        return interval or plain(figure.low)
    return f"{plain(figure.value)} ({interval})" if ".." in interval else plain(figure.value)


def plain(value: float | None, digits: int = 3) -> str:
    """Return a number with ``digits`` significant ones and no exponent; ``?`` for None."""
    if value is None:
        return "?"
    text = f"{value:.{digits}g}"
    if "e" not in text:
        return text
    return f"{float(text):.0f}" if abs(value) >= 1 else f"{float(text):.12f}".rstrip("0")


def span(low: float, high: float, digits: int = 3) -> str:
    """Return ``0.7`` or ``0.6..0.8``."""
    ends = plain(low, digits), plain(high, digits)
    return ends[0] if ends[0] == ends[1] else "..".join(ends)


def listed(names: Sequence[str], *, nothing: str = "none") -> str:
    """Return names with commas; a word where there are none."""
    return ", ".join(names) or nothing
