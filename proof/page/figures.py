"""The figure of the reliability of the confidence."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from torquerig.reporting.figures.picture import new_figure

INK, GRID = "#12395b", "#c6ccd2"


def reliability_figure(rows: Sequence[tuple[float, float, int]]) -> Figure:
    """Return the reliability diagram; ``rows`` are (mean confidence, share right, number) of each bin."""
    figure = new_figure(5.2, 4.4)
    axes = figure.add_subplot()
    axes.plot([0, 1], [0, 1], "--", color=GRID, linewidth=1.0, zorder=1)
    most = max((count for *_, count in rows), default=1)
    for confidence, right, count in rows:
        axes.plot(confidence, right, "o", color=INK, markersize=4 + 12 * np.sqrt(count / most), alpha=0.8, zorder=2)
        axes.annotate(str(count), (confidence, right), xytext=(8, -8), textcoords="offset points", fontsize=8)
    axes.set(xlim=(0, 1.02), ylim=(-0.02, 1.04), aspect="equal", xlabel="stated confidence",
             ylabel="share of right findings")  # fmt: skip
    return figure
