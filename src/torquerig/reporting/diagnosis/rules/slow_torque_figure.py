"""The slow torque of every run over time, with the prediction of the models on held-out stretches."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from torquerig.diagnosis.showing.comparison import Compared, Side
from torquerig.diagnosis.showing.comparison_curves import held_spans, slow_course
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE, RECORDED
from torquerig.reporting.figures.picture import new_figure

_MOST = 6


def slow_torque_figure(runs: Sequence[Compared]) -> Figure:
    """Return a panel per run: means over 20 ms, shaded held-out stretches, the models' slow torque on these."""
    shown = runs[:_MOST]
    figure = new_figure(10.5, 0.6 + 1.6 * len(shown))
    panels = figure.subplots(len(shown), 1, squeeze=False)[:, 0]
    for axes, one in zip(panels, shown, strict=True):
        _draw(axes, one)
    panels[-1].set_xlabel("time [s]")
    panels[0].legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    return figure


def _draw(axes: Axes, one: Compared) -> None:
    time, torque = slow_course(one.held.observed)
    axes.plot(time, torque, color=RECORDED, linewidth=0.7, label="recording, 20 ms means")
    for place, (start, stop) in enumerate(held_spans(one.held)):
        axes.axvspan(start, stop, color="#fff4d6", zorder=0, label="_" if place else "held out")
    _model(axes, one, one.before, colour=BEFORE, label="calibrated model", width=1.6)
    if one.after is not one.before:
        _model(axes, one, one.after, colour=AFTER, label="with findings", width=1.2)
    axes.set_xlim(0, one.held.observed.recording.duration)
    axes.set_ylabel("torque [N m]")
    axes.set_title(one.held.observed.name, loc="left", fontsize=8)
    axes.grid(color="#e3e7eb", linewidth=0.6)


def _model(axes: Axes, one: Compared, side: Side, *, colour: str, label: str, width: float) -> None:
    """Draw levels of steady stretches and ramps, and the simulation of a run that reverses."""
    for place, part in enumerate(one.held.parts):
        span = np.array([part.start, part.stop]) / one.held.observed.rate
        level = np.full(2, side.expected.level[place])
        axes.plot(span, level, color=colour, linewidth=width, label="_" if place else label)
    if one.held.turning is None:
        return
    time, torque = slow_course(side.copy)
    for place, (start, stop) in enumerate(held_spans(one.held)):
        kept = np.asarray((time >= start) & (time <= stop))
        name = "_" if place else label
        axes.plot(time[kept], torque[kept], color=colour, linewidth=0.5 * width, label=name)
