"""A matplotlib figure inside a page: one inline SVG image, the same bytes for the same figure."""

from __future__ import annotations

from base64 import b64encode
from dataclasses import dataclass
from io import BytesIO
from typing import Any

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

STYLE: dict[Any, Any] = {
    "svg.hashsalt": "torquerig",  # ids of clip paths, otherwise new in each run
    "svg.fonttype": "path",
    "font.family": ["DejaVu Sans"],
    "font.size": 9.0,
    "path.simplify": True,
}


@dataclass(frozen=True, kw_only=True)
class Picture:
    """An image of a page: ``source`` holds all of it, ``told`` is what it shows, for those who do not see it."""

    source: str
    caption: str
    told: str


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure of ``width`` x ``height`` [in] that needs no screen and is kept in no global list."""
    with rc_context(STYLE):
        made = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(made)
    return made


def picture(figure: Figure, *, caption: str, told: str) -> Picture:
    """Return a figure as an image that a page can hold inline."""
    drawn = svg(figure)
    return Picture(source=f"data:image/svg+xml;base64,{b64encode(drawn).decode()}", caption=caption, told=told)


def svg(figure: Figure) -> bytes:
    """Return a figure as SVG, without a date."""
    buffer = BytesIO()
    for axes in figure.axes:
        axes.spines[["top", "right"]].set_visible(False)
    with rc_context(STYLE):
        figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
    return buffer.getvalue()
