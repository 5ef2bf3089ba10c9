"""Held-out torque or force over the position under measured motion, and residuals."""

from __future__ import annotations

from matplotlib.figure import Figure

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.diagnosis.showing.motion_curves import held_pieces
from torquerig.reporting.diagnosis.rules.motion_panels import MEASURED, drawn_models, label_panels
from torquerig.reporting.figures.picture import new_figure

_POINTS = 6000  # of a curve


def motion_position_figure(shown: MotionCompared, *, scale: Scale) -> Figure:
    """Return torque or force over the position above, residuals below, one curve per held-out stretch."""
    run, pieces = shown.run, held_pieces(shown.run)
    step = max(1, sum(piece.stop - piece.start for piece in pieces) // _POINTS)
    figure = new_figure(10.5, 5.6)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[3, 2])
    for index, piece in enumerate(pieces):
        thin = slice(piece.start, piece.stop, step)
        position = run.position[thin] / scale.place_unit
        name = "_" if index else ""
        above.plot(position, run.effort[thin], color=MEASURED, linewidth=2.0, alpha=0.5, label=name or "recording")
        for model in drawn_models(shown):
            above.plot(position, model.effort[thin], color=model.colour, linewidth=0.8, label=name or model.label)
            below.plot(position, (run.effort - model.effort)[thin], color=model.colour, linewidth=0.7)
    above.set_title(f"{run.name}, held-out stretches", loc="left", fontsize=8)
    below.margins(x=0)
    label_panels(above, below, across=f"position [{scale.place}]", scale=scale)
    return figure
