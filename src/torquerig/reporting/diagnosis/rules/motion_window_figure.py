"""A held-out window under measured motion: torque or force of recording and models over time, and residuals."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.diagnosis.showing.motion_curves import telling_window
from torquerig.reporting.diagnosis.rules.motion_panels import MEASURED, drawn_models, label_panels
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure


def motion_window_figure(shown: MotionCompared, *, scale: Scale) -> Figure:
    """Return the window with the largest improvement: torque or force above, residuals below."""
    window, run = telling_window(shown), shown.run
    time = np.arange(window.start, window.stop) / run.rate
    figure = new_figure(10.5, 4.6)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[2, 1])
    above.plot(*envelope(time, run.effort[window]), color=MEASURED, linewidth=2.4, alpha=0.6, label="recording")
    for model in drawn_models(shown):
        above.plot(*envelope(time, model.effort[window]), color=model.colour, linewidth=1.0, label=model.label)
        below.plot(*envelope(time, (run.effort - model.effort)[window]), color=model.colour, linewidth=0.9)
    above.set_title(f"{run.name}, {time[0]:.4g} to {time[-1]:.4g} s, held out", loc="left", fontsize=8)
    below.set_xlim(time[0], time[-1])
    label_panels(above, below, across="time [s]", scale=scale)
    return figure
