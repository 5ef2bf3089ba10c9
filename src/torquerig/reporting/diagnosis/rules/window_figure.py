"""A short held-out window: the recording, and level and lines of the models before and after."""

from __future__ import annotations

from math import pi

import numpy as np
from matplotlib.figure import Figure

from torquerig.diagnosis.showing.comparison import Compared
from torquerig.diagnosis.showing.comparison_curves import line_wave, window_of
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE, RECORDED
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure

_PERIODS = 12  # of the line that changes most
_SHORTEST = 0.05  # [s]


def diagnosis_window_figure(shown: Compared, *, ratio: float) -> Figure:
    """Return the window in the middle of the last held-out stretch, long enough to see the line that changes most."""
    row = len(shown.held.stretches) - 1
    window = window_of(shown.held, row=row, duration=window_length(shown, ratio=ratio))
    time = np.arange(window.start, window.stop) / shown.held.observed.rate
    figure = new_figure(10.5, 2.9)
    axes = figure.add_subplot()
    axes.plot(*envelope(time, shown.held.observed.torque[window]), color=RECORDED, linewidth=0.9, label="recording")
    sides = [(shown.before, BEFORE, "calibrated model")]
    sides += [] if shown.after is shown.before else [(shown.after, AFTER, "with findings")]
    for side, colour, label in sides:
        wave = line_wave(shown.held, side, row=row, window=window)
        axes.plot(*envelope(time, wave), color=colour, linewidth=1.1, label=label)
    axes.set_xlim(time[0], time[-1])
    axes.set_xlabel("time [s]")
    axes.set_ylabel("torque [N m]")
    axes.set_title(f"{shown.held.observed.name}: level and lines, without the random load", loc="left", fontsize=8)
    axes.grid(color="#e3e7eb", linewidth=0.6)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    return figure


def window_length(shown: Compared, *, ratio: float) -> float:
    """Return twelve periods of the line whose size changes most, one turn of the output shaft at most [s]."""
    speed = max(float(np.abs(shown.held.speed[-1]).mean()), 1e-3)
    turn = 2 * pi * ratio / speed
    change = np.abs(shown.after.expected.amplitude[-1] - shown.before.expected.amplitude[-1])
    if change.size == 0 or change.max() <= 0:
        return turn
    place = shown.held.places[int(np.argmax(change))]
    return min(max(_PERIODS / max(place.frequency(speed), 1e-3), _SHORTEST), turn)
