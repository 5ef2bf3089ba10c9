"""The effect of a filter chain in four panels: original, filtered, both, and their rolling means."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from torquerig.metrics.filter_evaluation import FilterEvaluation
from torquerig.metrics.truth_error import true_load
from torquerig.recordings.recording import Recording
from torquerig.reporting.figures.effort import effort_name, effort_unit
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure

ORIGINAL, FILTERED, LOAD = "#1c252e", "#2e9e5b", "#d1495b"
ROLLING = 1000  # samples (reference report, Appendix A, code line 10)
_GRID = "#e3e7eb"

Array = NDArray[np.float64]


def evaluation_figure(made: FilterEvaluation) -> Figure:
    """Return the four panels of an evaluation, with the rolling mean of the true load where it is known."""
    effect = made.effect
    unit = effort_unit(made.before)
    title = f"{made.chain}: standard deviation {effect.std_before:.4f} to {effect.std_after:.4f} {unit}"
    if made.placebo is not None:
        title += (f" ({effect.std_reduction_percent:.1f} % less; placebo at other orders "
                  f"{100 * min(made.placebo.std_cuts):.1f} to {100 * max(made.placebo.std_cuts):.1f} %)")  # fmt: skip
    return four_panels(made.before, made.after, title=title)


def four_panels(before: Recording, after: Recording, *, title: str = "") -> Figure:
    """Return original, filtered, both laid over each other, and rolling means of 1000 samples.

    Source: reference report, section 4.3.1 and Figures 4.8-4.10: the filtered part in green, the original in black.
    """
    figure = new_figure(10.5, 8.6)
    panels = figure.subplots(4, 1, sharex=True)
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
    return figure


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
