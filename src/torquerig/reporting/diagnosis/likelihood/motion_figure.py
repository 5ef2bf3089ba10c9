"""A run under measured motion: its effort, and the residuals of both models over time and over the position."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from torquerig.inference.motion.engine import MotionOutcome
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE, RECORDED
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure
from torquerig.rig.reading_place import effort_unit

_MOST = 4000  # points over the position


def motion_figure(outcome: MotionOutcome, row: int) -> Figure:
    """Return the figure of one run that has held-out frames."""
    run, unit = outcome.runs[row], effort_unit(outcome.completed).replace("*", " ")
    place = "position [m]" if unit == "N" else "angle [rad]"
    inside = np.flatnonzero(run.samples_of(run.held))
    figure = new_figure(10.5, 6.2)
    top, middle, low = figure.subplots(3, 1)
    top.plot(*envelope(run.time, run.effort), color=RECORDED, linewidth=0.8, label="recording")
    sides = [(outcome.held[1], BEFORE, "calibrated model")]
    sides += [(outcome.held[2], AFTER, "completed model")] if outcome.completes else []
    for judged, colour, label in sides:
        frames = np.zeros((run.held.size, run.frequencies.size))
        frames[run.held] = judged.residuals[row]
        left = run.signal(frames)
        middle.plot(*envelope(run.time, left), color=colour, linewidth=0.8, label=label)
        thin = inside[:: max(1, inside.size // _MOST)]
        low.plot(run.position[thin], left[thin], ".", color=colour, markersize=2, label=label)
    top.set_ylabel(f"effort [{unit}]")
    for axes, across in ((top, "time [s]"), (middle, "time [s]"), (low, place)):
        axes.set_xlabel(across)
        axes.grid(color="#e3e7eb", linewidth=0.6)
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    for axes in (middle, low):
        axes.set_ylabel(f"residual [{unit}]")
    top.set_title(run.name, loc="left", fontsize=8)
    return figure
