"""The reading error of each drive with each filter, one row per drive."""

from __future__ import annotations

from collections.abc import Sequence
from math import nan

from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from torquerig.metrics.figure import Figure as Metric
from torquerig.reporting.figures.effort import shown_unit
from torquerig.reporting.figures.picture import new_figure
from torquerig.study.results import DriveResult

SHAPES = "osD^vP*X<>"
COLOURS = ("#0072b2", "#e69f00", "#56b4e9", "#cc79a7", "#5b4a8a", "#d55e00", "#444444", "#009e73")
"""Of Okabe and Ito (2008), which colour-blind readers can distinguish; the shapes differ too."""


def error_figure(drives: Sequence[DriveResult], *, present: str) -> Figure:
    """Return a dot per filter and its interval as a bar, drives from the least error down."""
    run = [drive for drive in drives if drive.chains]
    run.sort(key=lambda drive: min(result.truth_error.value or 0.0 for result in drive.chains.values()), reverse=True)
    names = list(dict.fromkeys(name for drive in run for name in drive.chains))
    figure = new_figure(10.5, 1.3 + 0.27 * len(run))
    axes = figure.add_subplot()
    for place, name in enumerate(names):
        found = [(row, *_ends(drive.chains[name].truth_error)) for row, drive in enumerate(run) if name in drive.chains]
        colour = COLOURS[place % len(COLOURS)]
        height = 0.55 * ((place + 0.5) / len(names) - 0.5)
        for row, low, _, high in found:
            axes.plot([low, high], [row - height] * 2, color=colour,
                      linewidth=1.6, alpha=0.55, solid_capstyle="butt")  # fmt: skip
        axes.plot([value for _, _, value, _ in found], [row - height for row, *_ in found], SHAPES[place % len(SHAPES)],
                  color=colour, markersize=4.5, label=name)  # fmt: skip
    axes.set_yticks(range(len(run)), [drive.candidate.name for drive in run])
    for row, tick in enumerate(axes.get_yticklabels()):
        tick.set_fontweight("bold" if run[row].candidate.name == present else "normal")
    axes.set_ylim(-0.7, len(run) - 0.3)
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 1.5, 2.0, 3.0, 5.0, 7.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    unit = shown_unit(run[0].disturbance.unit) if run else "N m"
    axes.set_xlabel(f"reading error: rms of reading minus true load [{unit}]")
    axes.grid(axis="x", color="#dde2e7", linewidth=0.6)
    axes.set_axisbelow(True)
    for row in range(0, len(run), 2):
        axes.axhspan(row - 0.5, row + 0.5, color="#f5f7f9", zorder=0)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=6, fontsize=8, frameon=False)
    return figure


def _ends(error: Metric) -> tuple[float, float, float]:
    """Low, value and high; not a number where the error is unknown, which draws nothing."""
    value = nan if error.value is None else error.value
    return value if error.low is None else error.low, value, value if error.high is None else error.high
