"""The effect of a filter chain: original, filtered, both, their rolling means, a short part and the spectra."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec
from numpy.typing import NDArray

from torquerig.filters.filter_effect import LineLevel
from torquerig.metrics.filter_evaluation import FilterEvaluation
from torquerig.metrics.truth_error import true_load
from torquerig.recordings.recording import Recording
from torquerig.reporting.figures.effort import effort_name, effort_unit
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure
from torquerig.reporting.figures.signal_figure import draw_signal
from torquerig.reporting.figures.spectrum_figure import draw_spectrum

ORIGINAL, FILTERED, LOAD = "#6b7885", "#0072b2", "#d55e00"  # of Okabe and Ito (2008): no red next to green
ROLLING = 1000  # samples (reference report, Appendix A, code line 10)
SHORT = 0.3  # [s] of the panel in which single periods can be seen
HIGHEST = 2000.0  # [Hz] end of the spectra where no line is known
_GRID = "#e3e7eb"

Array = NDArray[np.float64]


def evaluation_figure(made: FilterEvaluation) -> Figure:
    """Return four panels over the whole recording, then 0.3 s of it and the spectra before and after.

    The rolling mean of the true load and the load itself are drawn where it is known.
    """
    effect = made.effect
    unit = effort_unit(made.before)
    title = f"{made.chain}: standard deviation {effect.std_before:.4f} to {effect.std_after:.4f} {unit}"
    if made.placebo is not None:
        title += (f" ({effect.std_reduction_percent:.1f} % less; placebo at other orders "
                  f"{100 * min(made.placebo.std_cuts):.1f} to {100 * max(made.placebo.std_cuts):.1f} %)")  # fmt: skip
    figure = new_figure(10.5, 15.5)
    grid = figure.add_gridspec(6, 1, height_ratios=(1, 1, 1, 1, 1.3, 2.4))
    _four_panels(_rows(figure, grid), made.before, made.after, title=title)
    start = min(1.0, made.before.duration / 2)
    draw_signal(figure.add_subplot(grid[4]), made.before, made.after, start=start, duration=SHORT)
    draw_spectrum(
        figure.add_subplot(grid[5]), made.before, made.after, lines=[level.line for level in effect.levels],
        motor_speed=_motor_speed(effect.levels), ratio=_ratio(effect.levels),
        highest=None if effect.levels else HIGHEST,
    )  # fmt: skip
    return figure


def four_panels(before: Recording, after: Recording, *, title: str = "") -> Figure:
    """Return original, filtered, both laid over each other, and rolling means of 1000 samples.

    Source: reference report, section 4.3.1 and Figures 4.8-4.10.
    """
    figure = new_figure(10.5, 8.6)
    _four_panels(_rows(figure, figure.add_gridspec(4, 1)), before, after, title=title)
    return figure


def _rows(figure: Figure, grid: GridSpec) -> list[Axes]:
    """Return four axes over the same time."""
    first = figure.add_subplot(grid[0])
    others = [figure.add_subplot(grid[row], sharex=first) for row in (1, 2, 3)]
    for axes in (first, *others[:2]):
        axes.tick_params(labelbottom=False)
    return [first, *others]


def _motor_speed(levels: Sequence[LineLevel]) -> float:
    """Return the motor speed [rad/s] at which the first line has its frequency; 0 without a line."""
    return 2 * pi * levels[0].frequency / levels[0].line.motor_order if levels else 0.0


def _ratio(levels: Sequence[LineLevel]) -> float:
    """Return the motor turns per output turn of the lines [1]; 1 without a line."""
    return levels[0].line.output_order / levels[0].line.motor_order if levels else 1.0


def _four_panels(panels: Sequence[Axes], before: Recording, after: Recording, *, title: str) -> None:
    time, first, last = before.time(), before.torque(), after.torque()
    for axes, curves, name in (
        (panels[0], ((first, ORIGINAL, 1.0),), "original"),
        (panels[1], ((last, FILTERED, 1.0),), "filtered"),
        (panels[2], ((first, ORIGINAL, 1.0), (last, FILTERED, 0.9)), "both"),
    ):
        for values, colour, alpha in curves:
            _curve(axes, time, values, colour, alpha=alpha)
        axes.set_ylabel(f"{name}\n{effort_name(before)} [{effort_unit(before)}]")
    low, high = min(first.min(), last.min()), max(first.max(), last.max())
    for axes in panels[:3]:
        axes.set_ylim(low - 0.04 * (high - low) - 1e-9, high + 0.04 * (high - low) + 1e-9)
    _means(panels[3], before, after)
    for axes in panels:
        axes.grid(color=_GRID, linewidth=0.6)
        axes.set_axisbelow(True)
    panels[3].set_xlabel("time [s]")
    panels[3].set_xlim(0, before.duration)
    if title:
        panels[0].set_title(title, loc="left", fontsize=9)


def _means(axes: Axes, before: Recording, after: Recording) -> None:
    curves = [(before.torque(), ORIGINAL, "original", 2.0), (after.torque(), FILTERED, "filtered", 1.1)]
    load = true_load(before)
    if load is not None:
        curves.append((load, LOAD, "true load", 0.9))
    window = min(ROLLING, before.samples)
    time = before.time()[window - 1 :] - 0.5 * (window - 1) / before.sample_rate
    for values, colour, label, width in curves:
        axes.plot(*envelope(time, rolling_mean(values, window)), color=colour, linewidth=width, label=label)
    axes.set_ylabel(f"mean of {window}\nsamples [{effort_unit(before)}]")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.98), fontsize=7.5, frameon=False, ncols=3)


def rolling_mean(values: Array, window: int) -> Array:
    """Return the mean of ``window`` consecutive samples, shape (samples - window + 1,)."""
    sums = np.concatenate([[0.0], np.cumsum(values - values.mean())])
    return np.asarray((sums[window:] - sums[:-window]) / window + values.mean())


def _curve(axes: Axes, time: Array, values: Array, colour: str, *, alpha: float) -> None:
    axes.plot(*envelope(time, values, columns=700), color=colour, linewidth=0.5, alpha=alpha)
