"""Bokeh plots as JSON for a page: no toolbar logo, no fixed colours of text, and the same bytes in each run."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import Any, Literal

BEFORE, AFTER, LOAD = "#8a97a5", "#0072b2", "#d55e00"
"""Curves, of the colour-blind-safe set of Okabe and Ito (2008), grey and two of its eight colours."""
NOTHING_YET = {"x": [0.0, 1.0], "y": [1.0, 1.0]}
"""Data of a curve until the page puts the samples of the first view there."""
HEIGHT = 280  # [px] of one plot; two of them and the answer fit on a screen


def plot_json(model: Any, target: str) -> dict[str, Any]:
    """Return what ``Bokeh.embed.embed_item`` draws into the element ``target``."""
    from bokeh.core.types import ID
    from bokeh.embed import json_item

    return _renumbered(json_item(model, ID(target)))


def new_plot(
    *, x_label: str, y_label: str, x_range: Any, y_type: Literal["linear", "log"] = "linear", height: int = HEIGHT
) -> Any:
    """Return an empty Bokeh plot as wide as the page, with zoom, pan and reset."""
    from bokeh.plotting import figure

    made = figure(
        height=height, sizing_mode="stretch_width", x_range=x_range, y_axis_type=y_type,
        tools="xpan,xwheel_zoom,xbox_zoom,ywheel_zoom,undo,reset", active_drag="xbox_zoom", active_scroll=None,
        x_axis_label=x_label, y_axis_label=y_label, background_fill_color=None, border_fill_color=None,
        outline_line_color=None, min_border_left=60,
    )  # fmt: skip
    made.toolbar.logo = None
    return made


def curve_switch(text: str, *, colour: str, renderers: Sequence[str], dashed: bool = False) -> dict[str, Any]:
    """Return a button of the page that shows or hides the ``renderers`` of these names."""
    return {"text": text, "colour": colour, "dashed": dashed, "renderers": list(renderers)}


def _renumbered(item: Any) -> dict[str, Any]:
    """Return the JSON with its ids counted from 1: Bokeh counts on over all plots of a process."""
    found: dict[str, str] = {}
    text = re.sub(
        r'"p(\d{4,})"', lambda match: f'"p{1000 + int(found.setdefault(match[1], str(len(found))))}"', json.dumps(item)
    )
    made = json.loads(text)
    assert isinstance(made, dict)
    return made
