"""Reading before and after a filter, the true load, and the error of both: over the whole recording, to zoom."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from torquerig.metrics.truth_error import true_load
from torquerig.reporting.figures.effort import effort_name, effort_unit
from torquerig.reporting.moving.packed_curve import converter_step, packed_curve
from torquerig.reporting.moving.plot_json import AFTER, BEFORE, LOAD, NOTHING_YET, curve_switch, new_plot, plot_json

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

FIRST_VIEW = 0.3  # [s] some turns of the shaft; the whole recording is one click on reset away
SHARE_OF_CODE = 0.25  # [1] of a converter step: resolution of curves computed from its codes, below their noise
NAMES = {"before": "reading before the filter", "after": "reading after the filter", "load": "true load"}
ERRORS = {"before": "error before the filter", "after": "error after the filter"}
SWITCHES = {"before": "before the filter", "after": "after the filter", "load": "true load"}
COLOURS = {"before": BEFORE, "after": AFTER, "load": LOAD}


def signal_plot(before: Recording, after: Recording, *, target: str, start: float) -> dict[str, Any]:
    """Return plot and curves for the page; ``start`` [s] is where the first view begins.

    The lower plot, of reading minus true load, is there where the recording knows the true load. Both share their
    time axis.
    """
    from bokeh.layouts import column
    from bokeh.models import Range1d

    load, step, unit = true_load(before), 1 / before.sample_rate, effort_unit(before)
    values = {"before": before.torque()}
    values |= {} if after is before else {"after": after.torque()}
    values |= {} if load is None else {"load": load}
    finest = SHARE_OF_CODE * converter_step(before.torque())
    x_range = Range1d(name="x", start=start, end=min(start + FIRST_VIEW, before.duration),
                      bounds=(0.0, before.duration))  # fmt: skip
    upper = _plot([(name, NAMES[name], COLOURS[name]) for name in values], x_range,
                  label=f"{effort_name(before)} [{unit}]")  # fmt: skip
    plots, differences = [upper], {}
    if load is not None:
        differences = {f"error {name}": [name, "load"] for name in ERRORS if name in values}
        lower = _plot([(f"error {name}", ERRORS[name], COLOURS[name]) for name in ERRORS if name in values], x_range,
                      label=f"error [{unit}]", height=200)  # fmt: skip
        upper.xaxis.visible = False  # that of the lower plot is for both
        plots.append(lower)
    return {
        "item": plot_json(column(*plots, sizing_mode="stretch_width"), target),
        "curves": {name: packed_curve(curve, start=0.0, step=step, coarsest=finest) for name, curve in values.items()},
        "differences": differences, "x": "time [s]", "unit": unit, "range": [0.0, before.duration],
        "legend": [
            curve_switch(SWITCHES[name], colour=COLOURS[name], dashed=name == "load",
                         renderers=[NAMES[name], *([ERRORS[name]] if name in ERRORS else [])])
            for name in values
        ],
    }  # fmt: skip


def _plot(curves: list[tuple[str, str, str]], x_range: Any, *, label: str, height: int = 260) -> Any:
    from bokeh.models import CrosshairTool, HoverTool

    plot = new_plot(x_label="time [s]", y_label=label, x_range=x_range, height=height)
    drawn = [
        plot.line("x", "y", source=_source(name), color=colour, line_width=1.8 if name == "load" else 1.3,
                  line_dash="dashed" if name == "load" else "solid", name=shown)
        for name, shown, colour in curves
    ]  # fmt: skip
    plot.add_tools(
        HoverTool(renderers=drawn, mode="vline", tooltips=[("", "$name"), ("time", "@x{0.00000} s"), (label, "@y")]),
        CrosshairTool(dimensions="height", line_color="#8a97a5"),
    )
    return plot


def _source(name: str) -> Any:
    from bokeh.models import ColumnDataSource

    return ColumnDataSource(data=NOTHING_YET, name=name)
