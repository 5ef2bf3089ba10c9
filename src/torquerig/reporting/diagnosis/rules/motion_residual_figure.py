"""Held-out residuals of both models over time under measured motion, a panel per run."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.diagnosis.showing.motion_curves import held_pieces
from torquerig.reporting.diagnosis.rules.motion_panels import GRID, HELD_OUT, drawn_models, effort_name
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure

MOST = 6
_COLUMNS = 900  # of a panel
_MEASURED_COLOUR = "#d5dae0"


def motion_residual_figure(runs: Sequence[MotionCompared], *, scale: Scale) -> Figure:
    """Return a panel per run: measured torque or force, and the residuals of held-out stretches."""
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
    axes.plot(
        *envelope(time, run.effort),
        color=_MEASURED_COLOUR,
        linewidth=0.7,
        label=f"measured {effort_name(scale)}",
        zorder=1,
    )
    for index, piece in enumerate(pieces):
        name = "_" if index else ""
        axes.axvspan(time[piece.start], time[piece.stop - 1], color=HELD_OUT, zorder=0, label=name or "held out")
        for model in drawn_models(one):
            residual = (run.effort - model.effort)[piece]
            drawn = envelope(time[piece], residual, columns=max(1, _COLUMNS // len(pieces)))
            axes.plot(*drawn, color=model.colour, linewidth=0.7, label=name or f"residual, {model.label}")
    axes.set_xlim(0, time[-1])
    axes.set_ylabel(f"{effort_name(scale)} [{scale.effort}]")
    axes.set_title(run.name, loc="left", fontsize=8)
    axes.grid(color=GRID, linewidth=0.6)
