"""Orders of a recording in three panels: labelled order spectrum, order map, and Campbell diagram as measured."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from numpy.typing import NDArray

from torquerig.orders.analysis.angle_resampling import over_angle
from torquerig.orders.analysis.line_detection import DetectedLine
from torquerig.orders.analysis.order_maps import LineMap, order_map, speed_map
from torquerig.orders.analysis.order_spectrum import LineSpectrum, order_spectrum
from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.recordings.recording import Recording
from torquerig.reporting.figures.effort import effort_unit
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.families import COLOURS, SHORT
from torquerig.reporting.figures.picture import new_figure

CURVE, FIXED, UNNAMED = "#12395b", "#d1495b", "#8a96a3"
MODE = "#ffffff"
_GRID = "#e3e7eb"
_BOX = {"facecolor": "white", "alpha": 0.75, "edgecolor": "none", "pad": 0.3}
_LABEL_STEP = 0.02  # [1] least distance of two labels, as a share of the axis
_DYNAMIC = 1e3  # [1] largest over smallest amplitude that a map's colours show
_LOWEST_ORDER, _LOWEST_FREQUENCY = 0.3, 5.0  # [1/rev], [Hz]


@dataclass(frozen=True, kw_only=True)
class OrderPicture:
    """Data of the three panels.

    Parameters
    ----------
    spectrum : LineSpectrum
        Over the order of the output shaft.
    order_map, speed_map : LineMap
    found : tuple of DetectedLine
        Lines above the noise floor, with their domain.
    ratio : float
        Motor turns per output turn [1].
    fastest : float
        Highest speed of the output shaft [rev/s].
    modes : mapping of str to float
        Natural frequencies of a model of the rig [Hz] by name; may be empty.
    unit : str
        Of the amplitudes.
    """

    spectrum: LineSpectrum
    order_map: LineMap
    speed_map: LineMap
    found: tuple[DetectedLine, ...]
    ratio: float
    fastest: float
    modes: dict[str, float] = field(default_factory=dict)
    unit: str = "N m"


def order_picture(
    recording: Recording, turns: NDArray[np.float64], *, lines: Sequence[KinematicLine], found: Sequence[DetectedLine],
    ratio: float, counted: float = 1.0, modes: Mapping[str, float] | None = None,
) -> OrderPicture:  # fmt: skip
    """Return what is drawn of a recording whose output shaft turned by ``turns``: spectrum, maps and lines."""
    even, rate = over_angle(recording, turns, fastest=counted), recording.sample_rate
    fastest = float(np.percentile(np.diff(turns), 99.9)) * rate
    orders = [one.place if one.detected_over == "order" else one.place / fastest for one in found]
    wanted = 1.3 * max([*orders, *(line.output_order for line in lines if line.harmonic == 1)])
    highest = min(wanted, 0.4 * rate / fastest)
    return OrderPicture(
        spectrum=order_spectrum(even, highest=highest),
        order_map=order_map(even, turns, rate, highest=highest),
        speed_map=speed_map(recording.torque(), turns, rate, highest=0.4 * rate),
        found=tuple(found),
        ratio=ratio,
        fastest=fastest,
        modes=dict(modes or {}),
        unit=effort_unit(recording),
    )


def order_figure(shown: OrderPicture, *, title: str = "") -> Figure:
    """Return the three panels; lines in the colours of their causes, fixed frequencies dashed."""
    figure = new_figure(10.5, 13.0)
    upper, middle, lower = figure.subplots(3, 1, height_ratios=[1.15, 1.0, 1.15])
    draw_order_spectrum(upper, shown)
    draw_order_map(middle, shown)
    draw_campbell_map(lower, shown)
    if title:
        upper.set_title(title, loc="left", fontsize=10)
    return figure


def draw_order_spectrum(axes: Axes, shown: OrderPicture) -> None:
    """Draw amplitude over order; what was found is named and marked by its domain."""
    places, amplitudes = shown.spectrum.places, shown.spectrum.amplitudes
    kept = places >= _LOWEST_ORDER
    axes.plot(*envelope(places[kept], amplitudes[kept], columns=900, logarithmic=True), color=CURVE, linewidth=0.7)
    axes.set(xscale="log", yscale="log", xlim=(_LOWEST_ORDER, float(places[-1])))
    peak = float(amplitudes[kept].max())
    low = max(float(np.percentile(amplitudes[kept], 5)) / 3, peak * 1e-6)
    axes.set_ylim(low, peak * (peak / low) ** 0.55)
    axes.set_ylabel(f"amplitude [{shown.unit}]")
    axes.set_xlabel("order of the output shaft [1/rev]")
    axes.grid(axis="y", color=_GRID, linewidth=0.6)
    _plain(axes.xaxis)
    on_shaft = [one for one in shown.found if one.detected_over == "order" and one.place >= _LOWEST_ORDER]
    last = -1.0
    span = np.log(np.array([_LOWEST_ORDER, places[-1]]))
    for one in sorted(on_shaft, key=lambda one: one.place):
        colour, name = _style(one)
        sure = one.axis == "order"
        axes.plot(one.place, one.amplitude, marker="o" if sure else "D", markersize=4, color=colour, linestyle="none",
                  markerfacecolor=colour if sure else "none")  # fmt: skip
        last = max((np.log(one.place) - span[0]) / (span[1] - span[0]), last + _LABEL_STEP)
        axes.text(last, 0.985, f"{name}  {one.place:.4g}: {one.amplitude:.2g}", transform=axes.transAxes, rotation=90,
                  va="top", ha="center", fontsize=6.5, color=colour,
                  bbox=_BOX)  # fmt: skip
    legend = "filled: order line, open: order or fixed frequency undecided"
    axes.text(0.005, 0.02, legend, transform=axes.transAxes, fontsize=7, color="#46525e")


def draw_order_map(axes: Axes, shown: OrderPicture) -> None:
    """Draw the order map: order lines are upright, fixed frequencies are the bent dashed ones."""
    one = shown.order_map
    kept = one.places >= _LOWEST_ORDER
    _mesh(axes, one.places[kept], _row_axis(one, shown.ratio), one.amplitudes[:, kept], scale="log", unit=shown.unit)
    axes.set_xlabel("order of the output shaft [1/rev]")
    axes.set_ylabel("motor speed [rpm]" if one.by_speed else "time [s]")
    if one.by_speed:
        for line in shown.found:
            if line.axis == "frequency":
                axes.plot(line.place / one.rows, _row_axis(one, shown.ratio), color=FIXED, linewidth=0.9,
                          linestyle=(0, (4, 3)))  # fmt: skip
    for line in shown.found:
        if line.axis == "order":
            axes.plot([line.place], [1.0], transform=axes.get_xaxis_transform(), marker="v", markersize=5,
                      color=_style(line)[0], clip_on=False, linestyle="none")  # fmt: skip
    axes.set_xlim(_LOWEST_ORDER, float(one.places[-1]))
    _plain(axes.xaxis)
    axes.set_title("order map: triangles mark order lines, dashed curves are fixed frequencies", loc="left", fontsize=9)


def draw_campbell_map(axes: Axes, shown: OrderPicture) -> None:
    """Draw frequency over speed as measured, with order lines, fixed lines and modes laid over it."""
    one = shown.speed_map
    rows = _row_axis(one, shown.ratio)
    highest = _highest(shown)
    kept = (one.places > 0) & (one.places <= highest)
    _mesh(axes, rows, one.places[kept], one.amplitudes[:, kept].T, scale="log" if one.by_speed else "linear",
          unit=shown.unit)  # fmt: skip
    axes.set_yscale("log")
    axes.set_ylim(_LOWEST_FREQUENCY, highest)
    axes.set_xlim(float(rows[0]), float(rows[-1]))
    for axis in (axes.xaxis, axes.yaxis) if one.by_speed else (axes.yaxis,):
        _plain(axis)
    axes.set_xlabel("motor speed [rpm]" if one.by_speed else "time [s]")
    axes.set_ylabel("frequency [Hz]")
    if one.by_speed:
        for line in shown.found:
            if line.axis == "order":
                axes.plot(rows, line.place * one.rows, color=_style(line)[0], linewidth=0.9)
    for line in shown.found:
        if line.axis == "frequency" and line.place <= highest:
            axes.axhline(line.place, color=FIXED, linewidth=0.9, linestyle=(0, (4, 3)))
            axes.text(0.995, line.place, f"{line.place:.4g} Hz {line.label}", transform=axes.get_yaxis_transform(),
                      ha="right", va="bottom", fontsize=7, color=FIXED, bbox=_BOX)  # fmt: skip
    for name, frequency in shown.modes.items():
        if frequency <= highest:
            axes.axhline(frequency, color=MODE, linewidth=1.2, linestyle=(0, (1, 2)))
            axes.text(0.005, frequency, f"{name}: {frequency:.4g} Hz", transform=axes.get_yaxis_transform(),
                      va="bottom", fontsize=7, color=MODE)  # fmt: skip
    words = "Campbell diagram as measured: rays are lines of the shaft" if one.by_speed else "frequencies over time"
    words += ", dashed are fixed frequencies"
    axes.set_title(words + (", dotted are modes of the model" if shown.modes else ""), loc="left", fontsize=9)


def _mesh(axes: Axes, x: np.ndarray, y: np.ndarray, values: np.ndarray, *, scale: str, unit: str) -> None:
    seen = values[np.isfinite(values) & (values > 0)]
    top = float(np.percentile(seen, 99.9)) if seen.size else 1.0
    shown = np.ma.masked_invalid(values)
    mesh = axes.pcolormesh(x, y, shown, norm=LogNorm(top / _DYNAMIC, top, clip=True), cmap="viridis",
                           shading="nearest", rasterized=True)  # fmt: skip
    axes.set_xscale(scale)
    bar = axes.figure.colorbar(mesh, ax=axes, pad=0.01)
    bar.set_label(f"amplitude [{unit}]")


def _row_axis(one: LineMap, ratio: float) -> np.ndarray:
    """Speeds as those of the motor [rpm], times as they are [s]."""
    return one.rows * ratio * 60 if one.by_speed else one.rows


def _highest(shown: OrderPicture) -> float:
    """Return the frequency up to which something was found, and some more [Hz]."""
    tops = [one.place * shown.fastest if one.detected_over == "order" else one.place for one in shown.found]
    return min(1.15 * max([*tops, *shown.modes.values(), 50.0]), float(shown.speed_map.places[-1]))


def _style(one: DetectedLine) -> tuple[str, str]:
    """Return colour and short name of a line."""
    if not one.causes:
        return UNNAMED, one.label or "no known cause"
    first = one.causes[0]
    name = SHORT[first.family] + (f" x{first.harmonic}" if first.harmonic > 1 else "")
    others = len(one.causes) - 1
    return COLOURS[first.family], f"{name} (or {others} other)" if others else name


def _plain(axis: Axis) -> None:
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
