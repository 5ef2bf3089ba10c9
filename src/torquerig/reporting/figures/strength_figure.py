"""The S-diagram: technical against economic rating, with the line of balance and curves of equal strength."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from torquerig.decide.strength import GOOD, UNSATISFACTORY, VERY_GOOD, Strength
from torquerig.reporting.figures.picture import new_figure

INK, PALE, GRID = "#12395b", "#a9b8c6", "#c6ccd2"
LEVELS = (0.2, 0.4, 0.6, 0.8)
FULL = 1.03  # [1] where the axes end


def strength_figure(found: Strength, *, winners: Collection[str] = ()) -> Figure:
    """Return a numbered dot per alternative with its uncertain range, the ideal at (1, 1).

    Thin curves join equal sqrt(x y); on the dashed diagonal both sides are equally good; left of the shaded edges the
    technical rating is unsatisfactory, right of the last one very good.
    """
    longest = max(len(name) for name in found.alternatives)
    figure = new_figure(9.0 + 0.08 * max(0, longest - 20), max(5.6, 0.19 * len(found.alternatives)))
    axes = figure.add_subplot()
    _background(axes)
    x, y = found.technical, found.economic
    for row, name in enumerate(found.alternatives):
        colour = INK if name in winners or not winners else "#5d7488"
        axes.plot([x.low[row], x.high[row]], [y.value[row]] * 2, color=colour, linewidth=1.2, alpha=0.5, zorder=2)
        axes.plot([x.value[row]] * 2, [y.low[row], y.high[row]], color=colour, linewidth=1.2, alpha=0.5, zorder=2)
        axes.plot(x.value[row], y.value[row], "o", color=colour, markersize=8 if name in winners else 6, zorder=3,
                  label=f"{row + 1}  {name}: S = {found.hyperbolic[row]:.2f}")  # fmt: skip
        axes.annotate(str(row + 1), (x.value[row], y.value[row]), xytext=(-6, 6), textcoords="offset points",
                      ha="right", fontweight="bold", color=colour, zorder=4)  # fmt: skip
    axes.plot(1, 1, "*", color="#0072b2", markersize=12, zorder=3, label="ideal", clip_on=False)
    axes.set(xlim=(0, FULL), ylim=(0, FULL), aspect="equal", xlabel="technical rating x", ylabel="economic rating y")
    axes.legend(loc="center left", bbox_to_anchor=(1.02, 0.5), fontsize=8, frameon=False)
    return figure


def _background(axes: Axes) -> None:
    axes.axvspan(0, UNSATISFACTORY, color="#fbdcbc", alpha=0.25, linewidth=0, zorder=0)
    axes.axvspan(VERY_GOOD, FULL, color="#cfe3f4", alpha=0.35, linewidth=0, zorder=0)
    axes.axvline(GOOD, color=GRID, linewidth=0.6, zorder=0)
    axes.plot([0, 1], [0, 1], "--", color=GRID, linewidth=1.0, zorder=1)
    for level in LEVELS:
        across = np.linspace(level**2, 1, 200)
        axes.plot(across, level**2 / across, color=PALE, linewidth=0.7, zorder=1)
        axes.annotate(f"S = {level:g}", (1, level**2), xytext=(-3, -10), textcoords="offset points", ha="right",
                      fontsize=7, color="#6b7c8c")  # fmt: skip
