"""The channels of a recording over time, one panel each, with all their samples to zoom."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.reporting.moving.packed_curve import packed_curve
from torquerig.reporting.moving.plot_json import AFTER, NOTHING_YET, curve_switch, new_plot, plot_json

HEIGHT = 200  # [px] of a panel
TIME_AXIS = "x"  # name of the axis that all panels share


def channels_plot(recording: Recording, names: Sequence[str], *, target: str) -> dict[str, Any]:
    """Return plot and curves for the page: each channel in its unit as recorded, all panels on one time axis.

    A sample without a finite number is drawn on the straight line between its neighbours.
    """
    from bokeh.layouts import column
    from bokeh.models import Range1d

    step, end = 1 / recording.sample_rate, recording.duration
    x_range = Range1d(name=TIME_AXIS, start=0.0, end=end, bounds=(0.0, end))
    keys = {name: f"{name} (channel)" if name == TIME_AXIS else name for name in names}
    panels = [_panel(key, recording.channel(name).unit, x_range) for name, key in keys.items()]
    for one in panels[:-1]:
        one.xaxis.visible = False  # that of the last panel is for all
    return {
        "item": plot_json(column(*panels, sizing_mode="stretch_width"), target),
        "curves": {
            key: packed_curve(bridged(recording.channel(name).values), start=0.0, step=step)
            for name, key in keys.items()
        },
        "differences": {}, "x": "time [s]", "unit": "", "range": [0.0, end],
        "legend": [curve_switch(key, colour=AFTER, renderers=[_curve(key)]) for key in keys.values()],
    }  # fmt: skip


def bridged(values: NDArray[Any]) -> NDArray[np.float64]:
    """Return the values with each run of numbers that are not finite replaced by a straight line."""
    numbers = np.asarray(values, dtype=np.float64)
    known = np.isfinite(numbers)
    if known.all():
        return numbers
    at = np.arange(numbers.size)
    return np.interp(at, at[known], numbers[known]) if known.any() else np.zeros(numbers.size)


def _curve(key: str) -> str:
    return f"curve of {key}"


def _panel(key: str, unit: str, x_range: Any) -> Any:
    from bokeh.models import ColumnDataSource, CrosshairTool, HoverTool

    plot = new_plot(x_label="time [s]", y_label=f"{key} [{unit}]", x_range=x_range, height=HEIGHT)
    drawn = plot.line("x", "y", source=ColumnDataSource(data=NOTHING_YET, name=key), color=AFTER, line_width=1.3,
                      name=_curve(key))  # fmt: skip
    plot.add_tools(
        HoverTool(renderers=[drawn], mode="vline", tooltips=[("time", "@x{0.00000} s"), (key, "@y")]),
        CrosshairTool(dimensions="height", line_color="#8a97a5"),
    )
    return plot
