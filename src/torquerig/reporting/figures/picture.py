"""A matplotlib figure inside a page or as a file: the same bytes for the same figure."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable, Mapping
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.ticker import FixedFormatter, Formatter, FuncFormatter

from torquerig.errors import InputError
from torquerig.harmless import harmless
from torquerig.reporting.figures.figure_data import figure_csv
from torquerig.reporting.figures.page_picture import Picture, plot_name
from torquerig.reporting.moving.page_scripts import csv_script, data_script
from torquerig.whole_file import refuse_unwritable, whole_file

STYLE: dict[Any, Any] = {
    "svg.hashsalt": "torquerig",  # ids of clip paths, otherwise new in each run
    "svg.fonttype": "path",
    "font.family": ["DejaVu Sans"],
    "font.size": 9.0,
    "path.simplify": True,
}


class NotebookFigure(Figure):
    """A figure that a notebook shows although no window system knows of it.

    ``moving`` returns the same as HTML with plots to zoom; a notebook prefers it to the picture.
    """

    moving: Callable[[], str] | None = None

    def _repr_html_(self) -> str | None:
        """Return the plots that move; None where there are none."""
        return None if self.moving is None else self.moving()

    def _repr_png_(self) -> bytes:
        """Return the picture as PNG."""
        return png(self)


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure of ``width`` x ``height`` [in] without a screen or a global list."""
    with rc_context(STYLE):
        made = NotebookFigure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(made)
    return made


def picture(
    figure: Figure, *, caption: str, alt_text: str, name: str = "", csv: str = "", plot: Mapping[str, Any] | None = None
) -> Picture:
    """Return a figure as an image that a page can hold inline.

    Parameters
    ----------
    csv : str
        Its data as CSV text, for the page to save; else, without a ``plot``, what the figure draws.
    plot : mapping, optional
        The same figure as a plot that moves, from ``reporting.moving``; it replaces the image on a screen.
    """
    drawn = svg(figure)
    csv = csv or ("" if plot else figure_csv(figure))
    return Picture(
        source=f"data:image/svg+xml;base64,{b64encode(drawn).decode()}", caption=caption, alt_text=alt_text, name=name,
        csv=csv_script(csv) if csv else "", plot=plot_name(name) if plot else "",
        data=data_script(f"data-{plot_name(name)}", plot) if plot else "",
    )  # fmt: skip


def write_picture(figure: Figure, path: Path, *, overwrite: bool = False) -> None:
    """Write a figure as .svg or .png, by the ending of ``path``; the same figure gives the same bytes.

    Raises
    ------
    InputError
        For another ending, a missing folder, or an existing file that may not be overwritten.
    """
    check_picture(path, overwrite=overwrite)
    drawn = svg(figure) if path.suffix.lower() == ".svg" else png(figure)
    with whole_file(path) as partial:
        partial.write_bytes(drawn)


def check_picture(path: Path, *, overwrite: bool = False) -> None:
    """Raise the InputError that writing a picture to ``path`` would raise, before a long calculation."""
    if path.suffix.lower() not in (".svg", ".png"):
        raise InputError(f"{path}: a picture is written as .svg or .png; choose one of these endings")
    if path.exists() and not overwrite:
        raise InputError(f"{path}: is there already; choose another name, or overwrite it with --force")
    if not path.parent.is_dir():
        raise InputError(f"{path}: there is no folder {path.parent}; make it first")
    refuse_unwritable(path)


def svg(figure: Figure) -> bytes:
    """Return a figure as SVG, without a date."""
    return _saved(figure, "svg", {"Date": None, "Creator": None})


def png(figure: Figure) -> bytes:
    """Return a figure as PNG at 150 dots per inch."""
    return _saved(figure, "png", {"Software": None})


def _saved(figure: Figure, ending: str, metadata: dict[str, Any]) -> bytes:
    _show_names_as_written(figure)
    for axes in figure.axes:
        axes.spines[["top", "right"]].set_visible(False)
    buffer = BytesIO()
    with rc_context(STYLE):
        figure.savefig(buffer, format=ending, dpi=150, metadata=metadata)
    return buffer.getvalue()


def _show_names_as_written(figure: Figure) -> None:
    """Let no name of a foreign file count as a formula of TeX, nor act on what shows the picture.

    Tick labels of a logarithmic axis are formulas of matplotlib's own; those that name things are fixed texts.
    """
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            labels = axis.get_major_formatter()
            if isinstance(labels, FixedFormatter | FuncFormatter):
                axis.set_major_formatter(FuncFormatter(partial(_as_written, labels)))
    for text in figure.findobj(Text):
        if isinstance(text, Text) and "mathdefault" not in text.get_text():
            text.set_text(_written(text.get_text()))


def _as_written(labels: Formatter, value: float, place: int | None) -> str:
    return _written(str(labels(value, place)))


def _written(text: str) -> str:
    return re.sub(r"(?<!\\)\$", r"\\$", harmless(text))
