"""Torque over time and its spectrum as Bokeh plots whose curves the page fills in, so that it draws each plot once."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import ceil, floor, log10
from typing import Any

import numpy as np

from torquerig.filters.filter_effect import LineLevel
from torquerig.metrics.truth_error import true_load
from torquerig.orders.kinematics.order_report_text import name_of
from torquerig.recordings.recording import Recording
from torquerig.recordings.spectrum import hann_spectrum
from torquerig.reporting.figures.effort import effort_name, effort_unit
from torquerig.reporting.figures.families import COLOURS
from torquerig.reporting.moving.plot_json import AFTER, BEFORE, LOAD, NOTHING_YET, new_plot, plot_json
from torquerig.studio.what_if.quick_curve import quick_curve

CURVES = {
    "before": ("reading before the filter", BEFORE), "after": ("reading after the filter", AFTER),
    "load": ("true load", LOAD),
}  # fmt: skip
FIRST_VIEW = 0.3  # [s] some turns of the shaft; the whole recording is one click on reset away
LEAST = 1e-9  # smallest amplitude that is drawn, below any converter step
DECADES = 5  # of the axis below the largest peak
BEYOND = 1.3  # [1] end of the first view of the spectrum, over the highest line
IN_VIEW = 2  # harmonics of each cause in the first view
HIGHEST = 2000.0  # [Hz] end of the first view where no line is known


def signal_view(before: Recording, after: Recording) -> dict[str, Any]:
    """Return plot and curves of the torque over time: before and after the filter, and the true load where known."""
    load, step = true_load(before), 1 / before.sample_rate
    values = {"before": before.torque(), "after": after.torque()} | ({} if load is None else {"load": load})
    return {
        "item": _signal_plot(tuple(values), f"{effort_name(before)} [{effort_unit(before)}]"),
        "curves": {name: quick_curve(curve, start=0.0, step=step) for name, curve in values.items()},
        "first": [0.0, min(FIRST_VIEW, before.duration)], "whole": [0.0, before.duration],
    }  # fmt: skip


def spectrum_view(before: Recording, after: Recording, levels: Sequence[LineLevel]) -> dict[str, Any]:
    """Return plot and curves of the amplitude spectrum, with the lines of the drive and their causes.

    Amplitudes are by a Hann window [N m]. Without ``levels``, as of a run that is not steady, no line is marked.
    """
    spectra = {
        name: hann_spectrum(one.torque(), one.sample_rate) for name, one in (("before", before), ("after", after))
    }
    frequency = spectra["before"][0]
    step, end = float(frequency[1] - frequency[0]), float(frequency[-1])
    top = 10.0 ** ceil(log10(max(LEAST, *(float(one[1:].max()) for _, one in spectra.values()))))
    low = 10.0 ** (floor(log10(top)) - DECADES)
    shown = [one.frequency for one in levels if one.line.harmonic <= IN_VIEW]
    highest = BEYOND * max(shown, default=HIGHEST / BEYOND)
    return {
        "item": _spectrum_plot(f"amplitude [{effort_unit(before)}]"),
        "curves": {
            name: quick_curve(np.log10(np.maximum(one[1:], LEAST)), start=step, step=step, logarithmic=True)
            for name, (_, one) in spectra.items()
        },
        "lines": {
            "x": [one.frequency for one in levels], "low": [low] * len(levels), "high": [top] * len(levels),
            "cause": [name_of(one.line) for one in levels], "colour": [COLOURS[one.line.family] for one in levels],
            "order": [f"{one.line.output_order:.5g} per output turn" for one in levels],
        },
        "first": [0.0, min(highest, end)], "whole": [0.0, end], "y": [low, top],
    }  # fmt: skip


@cache
def _signal_plot(names: tuple[str, ...], label: str) -> dict[str, Any]:
    from bokeh.models import Range1d

    plot = new_plot(x_label="time [s]", y_label=label, x_range=Range1d(name="x"), height=300)
    _add_curves(plot, names, tooltips=[("", "$name"), ("time", "@x{0.00000} s"), ("value", "@y")])
    return plot_json(plot, "")


@cache
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
                  legend_label=CURVES[name][0], name=CURVES[name][0])
        for name in names
    ]  # fmt: skip
    plot.add_tools(
        HoverTool(renderers=drawn, mode="vline", tooltips=tooltips),
        CrosshairTool(dimensions="height", line_color="#8a97a5"),
    )
    legend = plot.legend[0]
    legend.click_policy, legend.orientation, legend.location = "hide", "horizontal", "top_left"
    legend.background_fill_alpha, legend.border_line_color, legend.padding = 0.0, None, 2
    plot.add_layout(legend, "above")
