"""A recording at a glance: each channel over time, spectrum with orders, and histogram of levels."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator

from torquerig.recordings.inspection.channel_info import ChannelInfo
from torquerig.recordings.inspection.channel_summary import ChannelSummary
from torquerig.recordings.inspection.recording_info import RecordingInfo
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure
from torquerig.reporting.figures.spectrum_figure import AFTER

GRID = "#e3e7eb"
# what is marked, its colour and its height in the panel as a share
MARKS = {
    "no numbers": ("#d1495b", 0.97),
    "dropouts": ("#e08e2b", 0.93),
    "stuck": ("#8d6bb5", 0.89),
    "spikes": ("#2a7f62", 0.85),
    "gaps": ("#12395b", 0.81),
}
_MOST_CHANNELS = 4


def info_figure(info: RecordingInfo, *, main: str, output_speed: float | None = None) -> Figure:
    """Return the picture of a recording.

    Parameters
    ----------
    info : RecordingInfo
        With its summaries.
    main : str
        The channel whose spectrum and levels are drawn, the torque as a rule; it is drawn first.
    output_speed : float, optional
        Of the output shaft [rad/s]; gives the axis of orders.
    """
    others = [name for name, one in info.channels.items() if name != main and not one.truth]
    shown = [main, *others[: _MOST_CHANNELS - 1]]
    figure = new_figure(10.5, 3.4 + 1.2 * len(shown))
    rows = figure.add_gridspec(len(shown) + 1, 2, height_ratios=[1.6, *[1.0] * (len(shown) - 1), 2.1])
    panels = [figure.add_subplot(rows[0, :])]
    panels += [figure.add_subplot(rows[row, :], sharex=panels[0]) for row in range(1, len(shown))]
    for axes, name in zip(panels, shown, strict=True):
        _draw_envelope(axes, info, name)
        axes.set_axisbelow(True)
        axes.tick_params(labelbottom=axes is panels[-1])
    panels[-1].set_xlabel("time [s]")
    panels[0].set_title(
        f"{info.name}: {info.samples} samples at {info.sample_rate:g} Hz, {info.duration:g} s", loc="left"
    )
    _draw_spectrum(figure.add_subplot(rows[-1, 0]), info, main, output_speed)
    _draw_levels(figure.add_subplot(rows[-1, 1]), info[main], info.summaries[main], main)
    left_out = others[_MOST_CHANNELS - 1 :]
    if left_out:
        figure.text(0.01, 0.002, f"not drawn: {', '.join(left_out)}", fontsize=7, color="#5b6770")
    return figure


def _draw_envelope(axes: Axes, info: RecordingInfo, name: str) -> None:
    one, envelope = info[name], info.summaries[name].envelope
    time = envelope.centres() / info.sample_rate
    if envelope.width == 1:
        axes.plot(time, envelope.low, color=AFTER, linewidth=0.8)
    else:
        axes.fill_between(time, envelope.low, envelope.high, color=AFTER, linewidth=0.4)
    axes.set_ylabel(f"{name}\n[{one.unit}]" if not name.endswith(f"_{one.unit}") else name)
    axes.set_xlim(0, info.duration)
    axes.grid(color=GRID, linewidth=0.6)
    _mark(axes, info, one)


def _mark(axes: Axes, info: RecordingInfo, one: ChannelInfo) -> None:
    """Draw faults as ticks along the top, one row and colour for each kind."""
    places: dict[str, Sequence[float]] = {
        "no numbers": [run.first for run in one.not_numbers],
        "dropouts": [run.first for run in one.dropouts],
        "stuck": [run.first for run in one.stuck_runs],
        "spikes": one.spikes,
        "gaps": [gap.sample for gap in info.gaps],
    }
    for word, samples in places.items():
        if samples:
            colour, height = MARKS[word]
            axes.plot(
                np.asarray(samples) / info.sample_rate, np.full(len(samples), height),
                transform=axes.get_xaxis_transform(), linestyle="none", marker="v", markersize=5, color=colour,
                markeredgecolor="white", markeredgewidth=0.5, label=f"{word} ({len(samples)})",
            )  # fmt: skip
    if any(places.values()):
        axes.margins(y=0.4)
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=7, frameon=False)


def _draw_spectrum(axes: Axes, info: RecordingInfo, name: str, output_speed: float | None) -> None:
    one, power = info[name], info.summaries[name].power
    axes.set_xlabel("frequency [Hz]")
    axes.set_ylabel(f"amplitude [{one.unit}]")
    frequencies, amplitudes = power.spectrum(info.sample_rate)
    kept = (frequencies > 0) & (amplitudes > 0)
    if power.count == 0 or not kept.any():
        axes.text(0.5, 0.5, "no spectrum: too few samples", transform=axes.transAxes, ha="center", fontsize=8)
        axes.set_axis_off()
        return
    axes.plot(*envelope(frequencies[kept], amplitudes[kept], columns=500, logarithmic=True), color=AFTER, linewidth=0.7)
    axes.set_xscale("log")
    axes.set_yscale("log")
    peak = float(amplitudes[kept].max())
    axes.set_ylim(max(peak * 1e-6, float(np.percentile(amplitudes[kept], 2)) / 3), peak * 2)
    axes.set_xlim(0.8 * float(frequencies[kept][0]), info.sample_rate / 2)
    axes.grid(color=GRID, linewidth=0.6)
    _plain_ticks(axes)
    if output_speed:
        turns = output_speed / (2 * np.pi)
        orders = axes.secondary_xaxis(
            "top", functions=(lambda f: np.asarray(f) / turns, lambda o: np.asarray(o) * turns)
        )
        orders.set_xlabel("order of the output shaft [1/rev]")
        orders.xaxis.set_major_locator(LogLocator(numticks=8))
        orders.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _plain_ticks(axes: Axes) -> None:
    axes.xaxis.set_major_locator(LogLocator(numticks=8))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _draw_levels(axes: Axes, one: ChannelInfo, summary: ChannelSummary, name: str) -> None:
    axes.set_xlabel(f"{name} [{one.unit}]" if not name.endswith(f"_{one.unit}") else name)
    axes.set_ylabel("share of samples [%]")
    if summary.histogram is None:
        return
    counts = summary.histogram.counts
    axes.stairs(100 * counts / max(int(counts.sum()), 1), summary.histogram.edges(), fill=True, color=AFTER)
    for limit, clipped in ((one.minimum, one.clipped_low), (one.maximum, one.clipped_high)):
        if clipped:
            upper = limit == one.maximum
            axes.annotate(
                "clipped", (limit, 0.95), xycoords=("data", "axes fraction"), xytext=(-3 if upper else 3, 0),
                textcoords="offset points", rotation=90, va="top", ha="right" if upper else "left",
                fontsize=7, color=MARKS["no numbers"][0],
            )  # fmt: skip
    axes.set_axisbelow(True)
    axes.grid(axis="y", color=GRID, linewidth=0.6)
