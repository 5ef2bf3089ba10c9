"""A recording before and after a filter: 0.3 s of the time signal, and the spectrum with the lines."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.recordings.recording import Recording
from torquerig.reporting.figures.picture import new_figure
from torquerig.reporting.figures.signal_figure import draw_signal
from torquerig.reporting.figures.spectrum_figure import draw_spectrum

SHORT = 0.3  # [s] in which single periods can be seen


def before_after_figure(
    before: Recording, after: Recording, *, lines: Sequence[KinematicLine], motor_speed: float, ratio: float
) -> Figure:
    """Return the time signal above the spectrum.

    Parameters
    ----------
    before, after : Recording
        Of the same run.
    lines : sequence of KinematicLine
        Marked in the spectrum with their cause.
    motor_speed : float
        [rad/s]
    ratio : float
        Motor turns per output turn [1].
    """
    figure = new_figure(10.5, 8.0)
    grid = figure.add_gridspec(2, 1, height_ratios=(1, 1.8))
    start = min(1.0, before.duration / 2)
    draw_signal(figure.add_subplot(grid[0]), before, after, start=start, duration=SHORT)
    draw_spectrum(figure.add_subplot(grid[1]), before, after, lines=lines, motor_speed=motor_speed, ratio=ratio)
    return figure
