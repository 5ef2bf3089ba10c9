"""The two plots of a what-if as Bokeh models without curves: the page draws each once and fills the curves in.

The page's process makes them, while the other one computes: Bokeh takes half a second to import.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

from torquerig.reporting.moving.plot_json import AFTER, BEFORE, LOAD, NOTHING_YET, new_plot, plot_json

CURVES = {
    "before": ("reading before the filter", BEFORE), "after": ("reading after the filter", AFTER),
    "load": ("true load", LOAD),
}  # fmt: skip


def curve_switches(names: Sequence[str]) -> list[dict[str, Any]]:
    """Return text and colour of each curve, for buttons that show and hide it; the keyboard reaches no Bokeh legend."""
    return [{"text": CURVES[one][0], "colour": CURVES[one][1], "dashed": one == "load"} for one in names]


@cache
def plot_item(kind: str, names: tuple[str, ...], label: str) -> dict[str, Any]:
    """Return the JSON of a plot.

    Parameters
    ----------
    kind : {"signal", "spectrum"}
    names : tuple of str
        Of its curves, among those of ``CURVES``.
    label : str
        Of its vertical axis.
    """
    return _signal_plot(names, label) if kind == "signal" else _spectrum_plot(label)


def _signal_plot(names: tuple[str, ...], label: str) -> dict[str, Any]:
    from bokeh.models import Range1d

    plot = new_plot(x_label="time [s]", y_label=label, x_range=Range1d(name="x"), height=300)
    _add_curves(plot, names, tooltips=[("", "$name"), ("time", "@x{0.00000} s"), ("value", "@y")])
    return plot_json(plot, "")


def _spectrum_plot(label: str) -> dict[str, Any]:
    from bokeh.models import ColumnDataSource, HoverTool, Range1d

    plot = new_plot(x_label="frequency [Hz]", y_label=label, x_range=Range1d(name="x"), y_type="log", height=320)
    plot.y_range = Range1d(name="y", start=1e-6, end=1.0)
    nothing = ColumnDataSource(name="lines", data={key: [] for key in ("x", "low", "high", "cause", "colour", "order")})
    marks = plot.segment("x", "low", "x", "high", source=nothing, color="colour", line_width=1.5, line_alpha=0.6)
    found = [("line", "@cause"), ("frequency", "@x{0.00} Hz"), ("order", "@order")]
    plot.add_tools(HoverTool(renderers=[marks], tooltips=found))
    _add_curves(plot, ("before", "after"), tooltips=[("", "$name"), ("frequency", "@x{0.00} Hz"), ("amplitude", "@y")])
    return plot_json(plot, "")


def _add_curves(plot: Any, names: Sequence[str], *, tooltips: list[tuple[str, str]]) -> None:
    from bokeh.models import ColumnDataSource, CrosshairTool, HoverTool

    drawn = [
        plot.line("x", "y", source=ColumnDataSource(data=NOTHING_YET, name=name), color=CURVES[name][1],
                  line_width=1.8 if name == "load" else 1.3, line_dash="dashed" if name == "load" else "solid",
                  name=CURVES[name][0])
        for name in names
    ]  # fmt: skip
    plot.add_tools(
        HoverTool(renderers=drawn, mode="vline", tooltips=tooltips),
        CrosshairTool(dimensions="height", line_color="#8a97a5"),
    )
