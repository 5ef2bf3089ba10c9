"""Technical against economic rating: the S-diagram of VDI 2225."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from torquerig.decide.kesselring import KesselringResult
from torquerig.reporting.figures.picture import new_figure

NEAR = 0.015  # [1] dots nearer than this share one label


def rating_figure(technical: KesselringResult, economic: KesselringResult, *, named: tuple[str, ...]) -> Figure:
    """Return a dot per combination, bars over the uncertain range, the ``named`` ones numbered with a legend.

    The diagonal is where both ratings are equal; the nearer to the upper right corner on it, the better.
    """
    figure = new_figure(10.5, 4.8)
    axes = figure.add_subplot()
    x, y = technical.share, economic.share
    axes.plot([0, 1], [0, 1], color="#c6ccd2", linewidth=0.8, zorder=0)
    axes.plot(x, y, "o", color="#a9b8c6", markersize=4, alpha=0.7, zorder=1)
    labels: dict[tuple[float, float], list[str]] = {}
    for place, name in enumerate(named, start=1):
        row = technical.alternatives.index(name)
        for result, across in ((technical, True), (economic, False)):
            ends = np.array([result.total_low[row], result.total_high[row]]) / result.ideal
            line = (ends, [y[row]] * 2) if across else ([x[row]] * 2, ends)
            axes.plot(*line, color="#12395b", linewidth=0.8, alpha=0.4, zorder=2)
        axes.plot(x[row], y[row], "o", color="#12395b", markersize=6, zorder=3, label=f"{place}  {name}")
        near = next((at for at in labels if np.hypot(at[0] - x[row], at[1] - y[row]) < NEAR), (x[row], y[row]))
        labels.setdefault(near, []).append(str(place))
    for at, numbers in labels.items():
        axes.annotate(", ".join(numbers), at, xytext=(-5, 5), textcoords="offset points", ha="right", fontsize=9,
                      fontweight="bold", color="#12395b", zorder=4)  # fmt: skip
    axes.set_xlim(max(0.0, float(x.min()) - 0.08), 1.02)
    axes.set_ylim(max(0.0, float((economic.total_low / economic.ideal).min()) - 0.05), 1.04)
    axes.set_xlabel("technical rating x = T/T_max without the price")
    axes.set_ylabel("economic rating y")
    axes.grid(color="#e8ebee", linewidth=0.6)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False, handlelength=0,
                handletextpad=0, markerscale=0)  # fmt: skip
    return figure
