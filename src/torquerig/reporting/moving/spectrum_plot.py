"""Amplitude spectrum before and after a filter, with the lines of the drive and their causes, to zoom."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, log10
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from torquerig.orders.kinematics.order_report_text import name_of
from torquerig.recordings.spectrum import hann_spectrum
from torquerig.reporting.figures.effort import effort_unit
from torquerig.reporting.figures.families import COLOURS, NAMES
from torquerig.reporting.moving.packed_curve import packed_curve
from torquerig.reporting.moving.plot_json import AFTER, BEFORE, NOTHING_YET, curve_switch, new_plot, plot_json

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.orders.kinematics.line_families import Family
    from torquerig.recordings.recording import Recording

CURVES = {"before": ("before the filter", BEFORE), "after": ("after the filter", AFTER)}
LEAST = 1e-9  # smallest amplitude that is drawn, below any converter step
MOST_BINS = 200_000  # of one spectrum: 0.3 MB of the page; a recording of 16 s at 25 kHz has them all
RESOLUTION = 5e-4  # decades between two steps of a packed amplitude: 0.12 %
DECADES = 5  # of the axis below the largest peak


def spectrum_plot(
    before: Recording, after: Recording, *, target: str, lines: Sequence[KinematicLine], motor_speed: float,
    highest: float,
) -> dict[str, Any]:  # fmt: skip
    """Return plot and curves for the page; amplitudes by a Hann window, lines at their frequency.

    Parameters
    ----------
    lines : sequence of KinematicLine
        Each with its cause when the pointer is on it.
    motor_speed : float
        [rad/s]
    highest : float
        End of the first view [Hz]; what the page holds beyond is one click on reset away.
    """
    from bokeh.models import Range1d

    recordings = {"before": before} if after is before else {"before": before, "after": after}
    spectra = {name: hann_spectrum(one.torque(), one.sample_rate) for name, one in recordings.items()}
    frequency = spectra["before"][0][: _kept_bins(spectra["before"][0], highest)]
    peak = max(float(amplitude[1:].max()) for _, amplitude in spectra.values())
    top = 10.0 ** ceil(log10(max(peak, LEAST)))
    x_range = Range1d(name="x", start=0.0, end=min(highest, float(frequency[-1])), bounds=(0.0, float(frequency[-1])))
    plot = new_plot(x_label="frequency [Hz]", y_label=f"amplitude [{effort_unit(before)}]", x_range=x_range,
                    y_type="log", height=340)  # fmt: skip
    plot.y_range = Range1d(start=10.0 ** (floor(log10(top)) - DECADES), end=top)
    _draw(plot, recordings, lines, motor_speed=motor_speed)
    step = float(frequency[1] - frequency[0])
    return {
        "item": plot_json(plot, target),
        "curves": {
            name: packed_curve(_logarithm(amplitude[1 : frequency.size]), start=step, step=step, coarsest=RESOLUTION)
            | {"logarithmic": True}
            for name, (_, amplitude) in spectra.items()
        },
        "differences": {}, "x": "frequency [Hz]", "unit": effort_unit(before), "range": [0.0, float(frequency[-1])],
        "legend": [
            curve_switch(text, colour=colour, renderers=[text])
            for text, colour in [
                *(CURVES[name] for name in recordings), *((NAMES[one], COLOURS[one]) for one in _families(lines)),
            ]
        ],
    }  # fmt: skip


def _kept_bins(frequency: NDArray[np.float64], highest: float) -> int:
    """Return how many bins the page holds: all, or of a very long recording those up to the end of the first view."""
    first_view = int(np.searchsorted(frequency, highest, side="right"))
    return min(frequency.size, max(MOST_BINS, first_view))


def _logarithm(amplitude: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.log10(np.maximum(amplitude, LEAST)))


def _draw(plot: Any, recordings: dict[str, Recording], lines: Sequence[KinematicLine], *, motor_speed: float) -> None:
    from bokeh.models import ColumnDataSource, CrosshairTool, HoverTool

    low, high = plot.y_range.start, plot.y_range.end
    marks = []
    for family in _families(lines):
        own = [line for line in lines if line.family == family]
        place = [line.frequency(motor_speed) for line in own]
        source = ColumnDataSource(data={
            "x": place, "low": [low] * len(own), "high": [high] * len(own), "cause": [name_of(line) for line in own],
            "order": [f"{line.output_order:.5g} per output turn" for line in own],
        })  # fmt: skip
        marks.append(plot.segment("x", "low", "x", "high", source=source, color=COLOURS[family], line_width=1.5,
                                  line_alpha=0.55, name=NAMES[family]))  # fmt: skip
    drawn = [
        plot.line("x", "y", source=ColumnDataSource(data=NOTHING_YET, name=name), color=CURVES[name][1],
                  line_width=1.2, name=CURVES[name][0])
        for name in recordings
    ]  # fmt: skip
    plot.add_tools(
        HoverTool(renderers=marks, tooltips=[("line", "@cause"), ("frequency", "@x{0.00} Hz"), ("order", "@order")]),
        HoverTool(renderers=drawn, mode="vline",
                  tooltips=[("", "$name"), ("frequency", "@x{0.00} Hz"), ("amplitude", "@y")]),
        CrosshairTool(dimensions="height", line_color="#8a97a5"),
    )  # fmt: skip


def _families(lines: Sequence[KinematicLine]) -> list[Family]:
    return list(dict.fromkeys(line.family for line in lines))
