"""The held-out effort over the speed: what the calibrated model leaves, and what was found in its place."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.diagnosis.showing.motion_curves import LevelOverSpeed
from torquerig.reporting.diagnosis.motion_sides import AFTER_LABEL, BEFORE_LABEL, GRID, MEASURED
from torquerig.reporting.diagnosis.spectrum_figure import AFTER, BEFORE
from torquerig.reporting.figures.picture import new_figure

_POINTS = 1200  # of a cloud


def motion_speed_figure(shown: MotionCompared, level: LevelOverSpeed, *, scale: Scale) -> Figure:
    """Return two panels: clouds of one run, and means by speed of all."""
    figure = new_figure(10.5, 3.6)
    left, right = figure.subplots(1, 2, width_ratios=[3, 2])
    _clouds(left, shown, scale)
    _means(right, level, alone=shown.alone, scale=scale)
    for axes in (left, right):
        axes.axhline(0, color=MEASURED, linewidth=0.8, zorder=0)
        axes.set_xlabel(f"speed [{scale.speed}]")
        axes.xaxis.set_major_locator(MaxNLocator(5))
        axes.grid(color=GRID, linewidth=0.6)
        axes.legend(loc="best", fontsize=8, frameon=False)
    return figure


def _clouds(axes: Axes, shown: MotionCompared, scale: Scale) -> None:
    held = shown.run.held.nonzero()[0]
    thin = held[:: max(1, held.size // _POINTS)]
    speed = shown.run.speed[thin] / scale.speed_unit
    left = (shown.run.effort - shown.before)[thin]
    axes.plot(speed, left, ".", color=MEASURED, markersize=2.5, label="recording less calibrated model")
    if not shown.alone:
        added = (shown.after - shown.before)[thin]
        axes.plot(speed, added, ".", color=AFTER, markersize=2.0, label="what was found adds")
    axes.set_ylabel(f"effort [{scale.effort}]")
    axes.set_title(shown.run.name, loc="left", fontsize=8)


def _means(axes: Axes, level: LevelOverSpeed, *, alone: bool, scale: Scale) -> None:
    speed = level.speed / scale.speed_unit
    axes.axhspan(-level.tolerance, level.tolerance, color=GRID, zorder=0)
    axes.plot(speed, level.before, "o-", color=BEFORE, markersize=3, linewidth=0.9, label=BEFORE_LABEL)
    if not alone:
        axes.plot(speed, level.after, "o-", color=AFTER, markersize=3, linewidth=0.9, label=AFTER_LABEL)
    axes.set_ylabel(f"mean of what is left [{scale.effort}]")
    axes.set_title("all runs, means by speed", loc="left", fontsize=8)
