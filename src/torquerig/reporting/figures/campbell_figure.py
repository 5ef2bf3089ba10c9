"""A Campbell diagram: order lines over motor speed against modes, the strongest crossings marked and named."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullLocator

from torquerig.simulation.twin.crossings import Crossing
from torquerig.simulation.twin.lines import OrderLine
from torquerig.simulation.twin.modes import Mode

MODE = "#12395b"
PALETTE = ("#d1495b", "#1b9e77", "#b8860b", "#7570b3", "#1f78b4", "#a6761d", "#e7298a", "#66a61e")
UNKNOWN = "#b5bcc4"
SPAN = 40.0  # [1] highest over lowest speed shown


def draw_campbell(
    axes: Axes, modes: Sequence[Mode], lines: Sequence[OrderLine], crossings: Sequence[Crossing], *, speed: float,
    top_speed: float, named: int = 8,
) -> None:  # fmt: skip
    """Draw frequency over motor speed, both logarithmic, so that order lines are straight and parallel.

    Parameters
    ----------
    crossings : sequence of Crossing
        Strongest first; all are marked, ``named`` of them numbered as the table does.
    speed, top_speed : float
        Set-point and end of the axis [rad/s] of the motor.
    """
    to_rpm = 30 / pi
    low, high = top_speed * to_rpm / SPAN, top_speed * to_rpm
    heights = [mode.damped for mode in modes if mode.damped > 0]
    bottom, top = 0.35 * min(heights, default=10.0), 3.0 * max(heights, default=100.0)
    axes.set(xscale="log", yscale="log", xlim=(low, high), ylim=(bottom, top))
    colours = _colours(lines)
    for line in lines:
        known = line.amplitude is not None
        axes.plot([low, high], line.order * np.array([low, high]) / 60, zorder=1.0 if known else 0.5,
                  color=colours[line.cause] if known else UNKNOWN, linewidth=1.0 if known else 0.5)  # fmt: skip
    for number, mode in enumerate(modes, start=1):
        if mode.damped <= 0:
            continue
        axes.axhspan(mode.damped * (1 - mode.damping), mode.damped * (1 + mode.damping), color=MODE, alpha=0.07, lw=0)
        axes.axhline(mode.damped, color=MODE, linewidth=1.4, zorder=2)
        axes.text(low * 1.04, mode.damped * 1.03, f"mode {number}: {mode.damped:.4g} Hz, {100 * mode.damping:.0f} %",
                  color=MODE, fontsize=7.5, va="bottom")  # fmt: skip
    if speed:
        axes.axvline(abs(speed) * to_rpm, color="#222222", linewidth=0.9, linestyle=(0, (4, 3)), zorder=1.5)
        axes.text(abs(speed) * to_rpm, bottom * 1.04, " set-point", fontsize=7.5, va="bottom")
    _mark(axes, crossings, colours, low=low, named=named)
    axes.set_xlabel("motor speed [rpm]")
    axes.set_ylabel("frequency [Hz]")
    axes.set_title("Campbell diagram: order lines and modes", loc="left")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(lambda value, _: f"{value:g}")
        axis.set_minor_locator(NullLocator())
    _orders(axes, lines, colours, speed_rpm=high)
    handles = [Line2D([], [], color=colour, label=cause) for cause, colour in colours.items()]
    if any(line.amplitude is None for line in lines):
        handles.append(Line2D([], [], color=UNKNOWN, label="amplitude unknown"))
    axes.legend(handles=handles, loc="upper left", fontsize=7, framealpha=0.9, ncols=2)


def _mark(axes: Axes, crossings: Sequence[Crossing], colours: dict[str, str], *, low: float, named: int) -> None:
    shown = [one for one in crossings if one.torque is not None and one.speed_rpm >= low]
    strongest = max((one.torque or 0.0 for one in shown), default=1.0)
    places: dict[tuple[float, float], list[str]] = {}
    for row, one in enumerate(crossings, start=1):
        if one not in shown:
            continue
        place = (one.speed_rpm, one.frequency)
        size = 12 + 90 * (one.torque or 0.0) / strongest
        axes.scatter(*place, s=size, color=colours[one.line.cause], edgecolor="white", linewidth=0.6, zorder=3)
        if row <= named:
            places.setdefault(place, []).append(str(row))
    for place, numbers in places.items():
        axes.annotate(", ".join(numbers), place, xytext=(0, 7), textcoords="offset points", ha="center", fontsize=7.5,
                      fontweight="bold", zorder=4)  # fmt: skip


def _orders(axes: Axes, lines: Sequence[OrderLine], colours: dict[str, str], *, speed_rpm: float) -> None:
    """Write the orders of the lines of known amplitude where they leave the diagram, as far as there is room."""
    bottom, top = axes.get_ylim()
    last = 0.0
    for line in lines:
        height = line.order * speed_rpm / 60
        if line.amplitude is None or not bottom < height < top or height < 1.06 * last:
            continue
        last = height
        axes.text(1.008, height, f"M{line.order:g}", transform=axes.get_yaxis_transform(), fontsize=7, va="center",
                  color=colours[line.cause])  # fmt: skip


def _colours(lines: Sequence[OrderLine]) -> dict[str, str]:
    causes = dict.fromkeys(line.cause for line in lines if line.amplitude is not None)
    return {cause: PALETTE[row % len(PALETTE)] for row, cause in enumerate(causes)}
