"""The amplitude spectrum of a torque before and after a filter chain, its lines labelled by cause."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, log10

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.orders.kinematics.line_families import Family
from torquerig.recordings.recording import Recording
from torquerig.recordings.spectrum import hann_spectrum
from torquerig.reporting.figures.effort import effort_unit
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.families import COLOURS, NAMES, SHORT
from torquerig.reporting.figures.picture import new_figure

BEFORE, AFTER = "#9aa5b1", "#12395b"
SAME_PLACE = 0.4  # [Hz] lines nearer than this get one label
LABEL_STEP = 0.022  # [1] least distance of two labels, as a share of the axis


def spectrum_figure(
    before: Recording, after: Recording, *, lines: Sequence[KinematicLine], motor_speed: float, ratio: float,
    highest: float | None = None, title: str = "",
) -> Figure:  # fmt: skip
    """Return the amplitudes of the torque over frequency and output order, both recordings in one picture.

    Parameters
    ----------
    before, after : Recording
        Of the same run; the same one twice draws one curve.
    lines : sequence of KinematicLine
        Marked at the top in the colour of their family; the fundamentals are labelled with their cause.
    motor_speed : float
        Where the lines are marked [rad/s]; the mean measured speed is better than the set-point.
    ratio : float
        Motor turns per output turn [1]; gives the axis of orders.
    highest : float, optional
        End of the frequency axis [Hz]; 1.3 times the highest line when not given.
    """
    figure = new_figure(10.5, 5.0)
    draw_spectrum(
        figure.add_subplot(), before, after, lines=lines, motor_speed=motor_speed, ratio=ratio, highest=highest,
        title=title,
    )  # fmt: skip
    return figure


def draw_spectrum(
    axes: Axes, before: Recording, after: Recording, *, lines: Sequence[KinematicLine], motor_speed: float,
    ratio: float, highest: float | None = None, title: str = "",
) -> None:  # fmt: skip
    """Draw the amplitudes of both recordings into ``axes``; parameters as for :func:`spectrum_figure`."""
    top = highest or 1.3 * max((line.frequency(motor_speed) for line in lines), default=2000.0)
    peak = _draw(axes, before, top, colour=BEFORE, label="before" if after is not before else "reading")
    if after is not before:
        _draw(axes, after, top, colour=AFTER, label="after")
    _scales(axes, top=top, peak=peak, output_speed=abs(motor_speed) / ratio, unit=effort_unit(before))
    shown = [line for line in lines if line.frequency(motor_speed) <= top]
    mark_lines(axes, shown, motor_speed=motor_speed)
    if title:
        axes.set_title(title, loc="left", pad=8)


def mark_lines(axes: Axes, lines: Sequence[KinematicLine], *, motor_speed: float, labels: bool = True) -> None:
    """Draw a thin line per kinematic line, label the fundamentals once per place, and list the families in a legend."""
    groups: list[tuple[float, list[KinematicLine]]] = []
    for line in sorted(lines, key=lambda line: line.frequency(motor_speed)):
        place = line.frequency(motor_speed)
        axes.axvline(place, color=COLOURS[line.family], linewidth=0.7, alpha=0.45, zorder=0.5)
        if line.harmonic == 1 and groups and place - groups[-1][0] < SAME_PLACE:
            groups[-1][1].append(line)
        elif line.harmonic == 1:
            groups.append((place, [line]))
    if labels:
        _label(axes, groups)
    families: list[Family] = list(dict.fromkeys(line.family for line in lines))
    counts = {family: sum(line.family == family for line in lines) for family in families}
    handles = [
        Line2D([], [], color=COLOURS[one], linewidth=2, label=f"{NAMES[one]} ({counts[one]})") for one in families
    ]
    own = [Line2D([], [], color=curve.get_color(), linewidth=2, label=str(curve.get_label())) for curve in axes.lines
           if not str(curve.get_label()).startswith("_")]  # fmt: skip
    axes.legend(handles=[*own, *handles], loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False,
                title="lines (how many marked)", title_fontsize=8)  # fmt: skip


def _draw(axes: Axes, recording: Recording, top: float, *, colour: str, label: str) -> float:
    frequencies, amplitudes = hann_spectrum(recording.torque(), recording.sample_rate)
    kept = (frequencies >= 1.0) & (frequencies <= top)
    drawn = envelope(frequencies[kept], amplitudes[kept], columns=700, logarithmic=True)
    axes.plot(*drawn, color=colour, linewidth=0.7, label=label)
    return float(amplitudes[kept].max())


def _scales(axes: Axes, *, top: float, peak: float, output_speed: float, unit: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(1.0, top)
    axes.set_xlabel("frequency [Hz]")
    axes.set_ylabel(f"amplitude [{unit}]")
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    # no ticks behind the labels, which need the upper third
    axes.set_yticks([10.0**power for power in range(floor(log10(peak * 1e-5)), ceil(log10(peak)) + 1)])
    axes.yaxis.set_minor_locator(NullLocator())
    axes.set_ylim(peak * 1e-5, peak * 2e3)
    axes.grid(axis="y", color="#e3e7eb", linewidth=0.6)
    turns = output_speed / (2 * np.pi)
    if turns > 0:
        to_order, to_frequency = (lambda f: np.asarray(f) / turns), (lambda order: np.asarray(order) * turns)
        orders = axes.secondary_xaxis("top", functions=(to_order, to_frequency))
        orders.set_xlabel("order of the output shaft [1/rev]")
        orders.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        orders.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _label(axes: Axes, groups: Sequence[tuple[float, Sequence[KinematicLine]]]) -> None:
    """Write upright labels at the top, each moved right where it would overlap the one before."""
    last = -1.0
    low, high = np.log(axes.get_xlim())
    for frequency, lines in groups:
        place = max((np.log(frequency) - low) / (high - low), last + LABEL_STEP)
        last = place
        name = " = ".join(dict.fromkeys(SHORT[line.family] for line in lines))
        axes.text(
            place, 0.985, f"{name}  {frequency:.4g} Hz", transform=axes.transAxes, rotation=90, va="top", ha="center",
            fontsize=7, color=COLOURS[lines[0].family],
            bbox={"facecolor": "white", "alpha": 0.75, "edgecolor": "none", "pad": 0.4},
        )  # fmt: skip
