"""What a notebook shows of a result: a sentence and the first rows of its table."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pandas as pd

MOST_ROWS = 30  # that are shown; ``to_frame`` has all


def notebook_html(summary: str, frame: pd.DataFrame) -> str:
    """Return a sentence and the first rows of a table as HTML."""
    shown = frame.head(MOST_ROWS)
    more = "" if len(frame) <= MOST_ROWS else f"<p>{len(frame) - MOST_ROWS} more rows: to_frame()</p>"
    return f"<p>{escape(summary)}</p>{shown.to_html(border=0, na_rep='')}{more}"
