"""What a figure draws as CSV text: every curve, point and bar with its numbers, for a page to save."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from io import StringIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.colors import to_hex
from matplotlib.container import BarContainer
from matplotlib.figure import Figure

from torquerig.harmless import csv_cell

HEAD = ("panel", "curve", "x axis", "y axis", "x", "y")
_Row = tuple[str, str, str, str, str, str]


def figure_csv(figure: Figure) -> str:
    """Return one row per drawn point: panel, curve, axis labels, x and y; empty where a figure draws no data.

    Lines over a whole axis, such as a limit or a marked order, and shaded areas are no data. A curve in several pieces
    has the name that the legend gives to its colour.
    """
    names = _names(figure)
    rows = [row for number, axes in enumerate(figure.axes, start=1) for row in _rows(axes, number, names)]
    if not rows:
        return ""
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow(HEAD)
    writer.writerows([csv_cell(text) for text in row] for row in rows)
    return buffer.getvalue()


def _names(figure: Figure) -> dict[str, str]:
    """Return the name of each colour that a legend of the figure explains."""
    found: dict[str, str] = {}
    for axes in figure.axes:
        for line in axes.lines:
            if not _is_unnamed(line.get_label()):
                found.setdefault(to_hex(line.get_color()), str(line.get_label()))
    return found


def _rows(axes: Axes, number: int, names: dict[str, str]) -> Iterator[_Row]:
    panel = axes.get_title(loc="left") or axes.get_title() or f"panel {number}"
    lowest = axes.figure.axes[-1]  # of panels over each other it alone may have the label
    across, up = (" ".join(text.split()) for text in (axes.get_xlabel() or lowest.get_xlabel(), axes.get_ylabel()))
    for line in axes.lines:
        if not all(line.get_transform().contains_branch_seperately(axes.transData)):
            continue  # a mark over a whole axis, as axhline and axvline make it
        label = line.get_label()
        name = names.get(to_hex(line.get_color()), "") if _is_unnamed(label) else str(label)
        for x, y in zip(*map(np.atleast_1d, line.get_data()), strict=True):
            yield panel, name, across, up, _number(x), _number(y)
    for points in axes.collections:
        if isinstance(points, PathCollection):
            name = "" if _is_unnamed(points.get_label()) else str(points.get_label())
            for x, y in np.asarray(points.get_offsets()):
                yield panel, name, across, up, _number(x), _number(y)
    for bars in axes.containers:
        if isinstance(bars, BarContainer):
            yield from _bars(bars, axes, panel, (across, up))


def _bars(bars: BarContainer, axes: Axes, panel: str, labels: tuple[str, str]) -> Iterator[_Row]:
    lies = bars.orientation == "horizontal"
    axis = axes.yaxis if lies else axes.xaxis
    texts = {
        float(at): tick.get_text() for at, tick in zip(axis.get_majorticklocs(), axis.get_ticklabels(), strict=False)
    }
    name = "" if _is_unnamed(bars.get_label()) else str(bars.get_label())
    for bar in bars:
        size = bar.get_width() if lies else bar.get_height()
        middle = bar.get_y() + bar.get_height() / 2 if lies else bar.get_x() + bar.get_width() / 2
        if size:
            place = texts.get(float(round(middle, 6)), _number(middle))
            yield (panel, name, *labels, *((_number(size), place) if lies else (place, _number(size))))


def _is_unnamed(label: object) -> bool:
    return str(label).startswith("_")


def _number(value: float) -> str:
    return f"{float(value):.6g}" if np.isfinite(value) else "?"
