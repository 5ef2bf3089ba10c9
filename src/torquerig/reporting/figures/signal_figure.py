"""A section of the reading before and after a filter, with the true load of a simulation."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from torquerig.metrics.truth_error import true_load
from torquerig.recordings.recording import Recording
from torquerig.reporting.figures.effort import effort_name, effort_unit
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure
from torquerig.reporting.figures.spectrum_figure import AFTER, BEFORE

LOAD = "#d55e00"


def signal_figure(
    before: Recording, after: Recording, *, start: float, duration: float = 0.3, title: str = ""
) -> Figure:
    """Return ``duration`` seconds of the torque from ``start`` [s]; the true load where the recording has it."""
    figure = new_figure(10.5, 2.7)
    draw_signal(figure.add_subplot(), before, after, start=start, duration=duration, title=title)
    return figure


def draw_signal(
    axes: Axes, before: Recording, after: Recording, *, start: float, duration: float, title: str = ""
) -> None:
    """Draw ``duration`` seconds of the torque from ``start`` [s] into ``axes``."""
    time = before.time()
    kept = (time >= start) & (time <= start + duration)
    curves = [("before the filter", before.torque(), BEFORE, 0.8)]
    if after is not before:
        curves.append(("after the filter", after.torque(), AFTER, 1.3))
    load = true_load(before)
    if load is not None:
        curves.append(("true load", load, LOAD, 1.0))
    for label, values, colour, width in curves:
        axes.plot(*envelope(time[kept], values[kept]), color=colour, linewidth=width, label=label)
    axes.set_xlim(start, start + duration)
    axes.set_xlabel("time [s]")
    axes.set_ylabel(f"{effort_name(before)} [{effort_unit(before)}]")
    axes.grid(color="#e3e7eb", linewidth=0.6)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    if title:
        axes.set_title(title, loc="left")
