"""The spectrum before and after a chain of band-stops, one above the other, with every notched line marked."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator

from torquerig.filters.filter_effect import LineLevel
from torquerig.recordings.recording import Recording
from torquerig.recordings.spectrum import amplitude_spectrum
from torquerig.reporting.figures.effort import effort_unit
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.families import COLOURS
from torquerig.reporting.figures.picture import new_figure
from torquerig.reporting.figures.spectrum_figure import AFTER, mark_lines


def notch_figure(before: Recording, after: Recording, *, levels: Sequence[LineLevel], motor_speed: float) -> Figure:
    """Return both spectra on the same axes, a triangle at each line of ``levels``.

    Without a window, as in the reference report: the removed bands are then exactly zero.
    """
    figure = new_figure(10.5, 5.4)
    upper, lower = figure.subplots(2, 1, sharex=True, sharey=True)
    top = 1.15 * max((level.frequency for level in levels), default=1000.0)
    for axes, recording, name in ((upper, before, "before"), (lower, after, "after")):
        frequencies, amplitudes = amplitude_spectrum(recording.torque(), recording.sample_rate)
        kept = (frequencies > 0) & (frequencies <= top)
        drawn = envelope(frequencies[kept], amplitudes[kept], columns=800, logarithmic=True)
        axes.plot(*drawn, color=AFTER, linewidth=0.7)
        axes.set_ylabel(f"{name}\namplitude [{effort_unit(before)}]")
        axes.grid(axis="y", color="#e3e7eb", linewidth=0.6)
    upper.set_yscale("log")
    peak = max((level.before for level in levels), default=1.0)
    upper.set_ylim(peak * 1e-5, peak * 8)
    upper.set_xscale("log")
    upper.set_xlim(2.0, top)
    lower.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    lower.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    lower.set_xlabel("frequency [Hz]")
    for level in levels:
        for axes in (upper, lower):
            axes.plot(level.frequency, peak * 4, marker="v", markersize=5, color=COLOURS[level.line.family],
                      linestyle="none")  # fmt: skip
    mark_lines(upper, [level.line for level in levels], motor_speed=motor_speed, labels=False)
    return figure
