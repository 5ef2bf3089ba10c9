"""How values show themselves: as a picture, and as HTML in a notebook.

Pictures are drawn by ``torquerig.reporting``, which is above the packages that hold the values. So it is imported by
name, and only when a picture is drawn: the one place where a lower package reaches a higher one.
"""

from __future__ import annotations

from html import escape
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

MOST_ROWS = 30  # of a table that a notebook shows; ``to_frame`` has all


def figure(name: str, value: object, **options: Any) -> Figure:
    """Return the picture of a value, drawn by the function ``name`` in the module of that name in reporting.figures."""
    made: Figure = getattr(import_module(f"torquerig.reporting.figures.{name}"), name)(value, **options)
    return made


def notebook_html(summary: str, frame: pd.DataFrame) -> str:
    """Return a sentence and the first rows of a table as HTML."""
    shown = frame.head(MOST_ROWS)
    more = "" if len(frame) <= MOST_ROWS else f"<p>{len(frame) - MOST_ROWS} more rows: to_frame()</p>"
    return f"<p>{escape(summary)}</p>{shown.to_html(border=0, na_rep='')}{more}"
