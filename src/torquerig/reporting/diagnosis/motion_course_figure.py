"""What both models leave of each run over time under measured motion, where no fit has looked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.diagnosis.showing.motion_curves import held_pieces
from torquerig.reporting.diagnosis.motion_sides import GRID, HELD, sides
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure

MOST = 6
_COLUMNS = 900  # of a panel
_EFFORT = "#d5dae0"


def motion_course_figure(runs: Sequence[MotionCompared], *, scale: Scale) -> Figure:
    """Return a panel per run: the effort over all of it, the residuals of held-out stretches."""
    shown = runs[:MOST]
    figure = new_figure(10.5, 0.6 + 1.8 * len(shown))
    panels = figure.subplots(len(shown), 1, squeeze=False)[:, 0]
    for axes, one in zip(panels, shown, strict=True):
        _draw(axes, one, scale)
    panels[-1].set_xlabel("time [s]")
    panels[0].legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    return figure


def _draw(axes: Axes, one: MotionCompared, scale: Scale) -> None:
    run = one.run
    time, pieces = np.arange(run.effort.size) / run.rate, held_pieces(run)
    axes.plot(*envelope(time, run.effort), color=_EFFORT, linewidth=0.7, label="measured effort", zorder=1)
    for index, piece in enumerate(pieces):
        name = "_" if index else ""
        axes.axvspan(time[piece.start], time[piece.stop - 1], color=HELD, zorder=0, label=name or "no fit has looked")
        for side in sides(one):
            left = (run.effort - side.effort)[piece]
            drawn = envelope(time[piece], left, columns=max(1, _COLUMNS // len(pieces)))
            axes.plot(*drawn, color=side.colour, linewidth=0.7, label=name or f"left, {side.label}")
    axes.set_xlim(0, time[-1])
    axes.set_ylabel(f"effort [{scale.effort}]")
    axes.set_title(run.name, loc="left", fontsize=8)
    axes.grid(color=GRID, linewidth=0.6)
