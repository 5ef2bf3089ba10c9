"""The value profile: points of each alternative per criterion, as wide as the points and as thick as the weight."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from torquerig.decide.kesselring import KesselringResult
from torquerig.reporting.figures.picture import new_figure

MOST = 6  # alternatives side by side; more would be too small to read
BAR, OPEN, WEAK = "#5b88ad", "#12395b", "#d55e00"


def value_profile(result: KesselringResult, *, named: Sequence[str] = ()) -> Figure:
    """Return a row of bars per alternative: length the points, height the weight, a line over the uncertain range.

    The area of all bars is T. Cells with at most one point above the worst are red: weak spots, which a high total
    hides.

    Parameters
    ----------
    named : sequence of str
        Which alternatives; the best ``MOST`` by T when not given.
    """
    best = [result.alternatives[row] for row in np.argsort(-result.total, kind="stable").tolist()]
    shown = [name for name in (named or best) if name in result.alternatives][:MOST]
    figure = new_figure(2.2 + 1.9 * len(shown), 1.2 + 0.38 * len(result.criteria))
    panels = figure.subplots(1, len(shown), sharey=True, squeeze=False)[0]
    heights = result.normalised
    centres = 1 - np.cumsum(heights) + heights / 2
    floor = min(0.0, result.profile.p_min)
    for axes, name in zip(panels, shown, strict=True):
        row = result.alternatives.index(name)
        weak = result.high[row] <= result.profile.weak + 1e-9
        colours = [WEAK if one else BAR for one in weak.tolist()]
        axes.barh(centres, result.middle[row] - floor, left=floor, height=0.9 * heights, color=colours, linewidth=0)
        for centre, low, high in zip(centres, result.low[row], result.high[row], strict=True):
            axes.plot([low, high], [centre, centre], color=OPEN, linewidth=1.5)
        axes.set(xlim=(floor, result.profile.p_max), ylim=(0, 1))
        title = name.replace(" | ", "\n")
        axes.set_title(f"{title}\nT/T_max {result.share[row]:.2f}", fontsize=8)
        axes.tick_params(labelsize=8)
    panels[0].set_yticks(
        centres, [f"{name} ({share:.0%})" for name, share in zip(result.criteria, heights, strict=True)]
    )
    return figure
