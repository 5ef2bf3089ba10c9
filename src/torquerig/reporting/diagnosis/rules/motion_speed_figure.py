"""Held-out residuals over the speed under measured motion, with the effect of the findings."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.diagnosis.showing.motion_curves import LevelOverSpeed
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE
from torquerig.reporting.diagnosis.rules.motion_panels import AFTER_LABEL, BEFORE_LABEL, GRID, MEASURED, effort_name
from torquerig.reporting.figures.picture import new_figure

_POINTS = 1200  # largest number of samples drawn


def motion_speed_figure(shown: MotionCompared, level: LevelOverSpeed, *, scale: Scale) -> Figure:
    """Return two panels: samples of one run, and means over speed bins of all runs."""
    figure = new_figure(10.5, 3.6)
    left, right = figure.subplots(1, 2, width_ratios=[3, 2])
    _samples(left, shown, scale)
    _means(right, level, alone=shown.alone, scale=scale)
    for axes in (left, right):
        axes.axhline(0, color=MEASURED, linewidth=0.8, zorder=0)
        axes.set_xlabel(f"speed [{scale.speed}]")
        axes.xaxis.set_major_locator(MaxNLocator(5))
        axes.grid(color=GRID, linewidth=0.6)
        axes.legend(loc="best", fontsize=8, frameon=False)
    return figure


def _samples(axes: Axes, shown: MotionCompared, scale: Scale) -> None:
    held = shown.run.held.nonzero()[0]
    thin = held[:: max(1, held.size // _POINTS)]
    speed = shown.run.speed[thin] / scale.speed_unit
    left = (shown.run.effort - shown.before)[thin]
    axes.plot(speed, left, ".", color=MEASURED, markersize=2.5, label="recording minus calibrated model")
    if not shown.alone:
        added = (shown.after - shown.before)[thin]
        axes.plot(speed, added, ".", color=AFTER, markersize=2.0, label="effect of the findings")
    axes.set_ylabel(f"{effort_name(scale)} [{scale.effort}]")
    axes.set_title(shown.run.name, loc="left", fontsize=8)


def _means(axes: Axes, level: LevelOverSpeed, *, alone: bool, scale: Scale) -> None:
    speed = level.speed / scale.speed_unit
    axes.axhspan(-level.tolerance, level.tolerance, color=GRID, zorder=0)
    axes.plot(speed, level.before, "o-", color=BEFORE, markersize=3, linewidth=0.9, label=BEFORE_LABEL)
    if not alone:
        axes.plot(speed, level.after, "o-", color=AFTER, markersize=3, linewidth=0.9, label=AFTER_LABEL)
    axes.set_ylabel(f"mean residual [{scale.effort}]")
    axes.set_title("all runs, mean residual by speed", loc="left", fontsize=8)
