"""The held-out effort over the place under measured motion: loops of a motion to and fro, lines of one that turns."""

from __future__ import annotations

from matplotlib.figure import Figure

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.diagnosis.showing.motion_curves import held_pieces
from torquerig.reporting.diagnosis.motion_sides import MEASURED, finished, sides
from torquerig.reporting.figures.picture import new_figure

_POINTS = 6000  # of a curve


def motion_place_figure(shown: MotionCompared, *, scale: Scale) -> Figure:
    """Return the effort over the place, above, and what the models leave, below, stretch by stretch."""
    run, pieces = shown.run, held_pieces(shown.run)
    step = max(1, sum(piece.stop - piece.start for piece in pieces) // _POINTS)
    figure = new_figure(10.5, 5.6)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[3, 2])
    for index, piece in enumerate(pieces):
        thin = slice(piece.start, piece.stop, step)
        place = run.position[thin] / scale.place_unit
        name = "_" if index else ""
        above.plot(place, run.effort[thin], color=MEASURED, linewidth=2.0, alpha=0.5, label=name or "recording")
        for side in sides(shown):
            above.plot(place, side.effort[thin], color=side.colour, linewidth=0.8, label=name or side.label)
            below.plot(place, (run.effort - side.effort)[thin], color=side.colour, linewidth=0.7)
    above.set_title(f"{run.name}, held-out stretches", loc="left", fontsize=8)
    below.margins(x=0)
    finished(above, below, across=f"place [{scale.place}]", scale=scale)
    return figure
