"""A Bokeh plot in the page: its curves are sent whole, and the page draws what its view can show."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nicegui import ui


class Plot(ui.element, component="page/studio_plot.js"):
    """A place for a plot; empty until :meth:`show`.

    Parameters
    ----------
    name : str
        What it shows, for a screen reader.
    """

    def __init__(self, name: str) -> None:
        super().__init__()
        self.props["name"] = name

    def show(self, view: Mapping[str, Any]) -> None:
        """Draw a view of ``torquerig.studio.what_if.plots``, or its curves in the plot that is there."""
        from torquerig.studio.what_if.plot_items import curve_switches, plot_item

        kind, names, label = view["plot"]
        drawn = {**view, "item": plot_item(kind, names, label), "switches": curve_switches(names)}
        self.run_method("show", drawn)


def prepare() -> None:
    """Import what draws the first plot; to be called in a thread, while the first curves are computed."""
    from torquerig.studio.what_if.plot_items import plot_item

    plot_item("signal", ("before", "after", "load"), "torque [N m]")
    plot_item("spectrum", ("before", "after"), "amplitude [N m]")
