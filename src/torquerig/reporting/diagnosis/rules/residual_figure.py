"""Held-out residuals of each model: spectrum between the lines, the lines, the slow torque of a reversing run."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator

from torquerig.diagnosis.fitting.misfit import BAND_TOLERANCE
from torquerig.diagnosis.showing.comparison import Compared, Side
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE
from torquerig.reporting.figures.picture import new_figure

_DECIBEL = 10 / np.log(10)
_LINEAR = 3.0  # [1] standardised residuals up to this value are drawn on a linear scale
_EXPECTED = "#e3e7eb"
_TICKS = (-1000, -300, -100, -30, -10, -3, 0, 3, 10, 30, 100, 300, 1000)


def diagnosis_residual_figure(shown: Compared | None, turning: Sequence[Compared]) -> Figure:
    """Return panels of the residuals: spectrum and lines of one run, and the first run that reverses."""
    panels = _panels(shown)
    count = len(panels) + bool(turning)
    figure = new_figure(10.5, 0.4 + 2.5 * count)
    axes = figure.subplots(count, 1, squeeze=False)[:, 0]
    for one, draw in zip(axes, panels, strict=False):
        if shown is not None:
            draw(one, shown)
    if turning:
        _turning(axes[-1], turning[0])
    axes[0].legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    return figure


def has_residuals(shown: Compared | None, turning: Sequence[Compared]) -> bool:
    """Return whether there is a spectrum, a line or a reversal to draw."""
    return bool(_panels(shown) or turning)


def _panels(shown: Compared | None) -> list[Callable[[Axes, Compared], None]]:
    if shown is None:
        return []
    return [*([_bands] if shown.held.power.size else []), *([_lines] if shown.held.places else [])]


def _sides(one: Compared) -> list[tuple[Side, str, str]]:
    sides = [(one.before, BEFORE, "calibrated model")]
    return sides if one.after is one.before else [*sides, (one.after, AFTER, "with findings")]


def _bands(axes: Axes, one: Compared) -> None:
    """Draw the density between the lines over that of each model [dB]; grey is the 95 % range of a true model."""
    held = one.held
    seen = np.where(np.isfinite(held.power) & (held.count > 0), held.count, np.nan)
    limit = 1.96 * _DECIBEL * np.sqrt(1 / seen + BAND_TOLERANCE**2)
    axes.fill_between(held.band, -limit, limit, color=_EXPECTED, step="mid", label="true model, 95 %")
    for side, colour, label in _sides(one):
        excess = _DECIBEL * np.log(held.power / side.expected.power)
        axes.step(held.band, excess, where="mid", color=colour, linewidth=1.2, label=label)
    _frequency_axis(axes, float(held.band[0]), float(held.band[-1]))
    axes.set_ylabel("recording over\nmodel [dB]")
    axes.set_title(f"{held.observed.name}: spectrum between the lines", loc="left", fontsize=8)


def _lines(axes: Axes, one: Compared) -> None:
    """Draw the standardised residual of each line."""
    at = one.held.line_frequency.mean(axis=(0, 2))
    axes.axhspan(-1.96, 1.96, color=_EXPECTED, zorder=0)
    for (side, colour, label), marker in zip(_sides(one), "ox", strict=False):
        residual = np.atleast_2d(side.misfit.lines)
        worst = residual[np.abs(residual).argmax(axis=0), np.arange(residual.shape[1])]
        axes.plot(at, worst, marker, color=colour, markersize=5, fillstyle="none", label=label)
    _standardised_axis(axes)
    _frequency_axis(axes, float(at.min()) * 0.8, float(at.max()) * 1.25)
    axes.set_ylabel("standardised residual\nof each line [1]")
    axes.set_title(f"{one.held.observed.name}: lines", loc="left", fontsize=8)


def _turning(axes: Axes, one: Compared) -> None:
    blocks = one.held.turning
    if blocks is None:
        return
    rpm = blocks.speed * 30 / np.pi
    for (side, colour, label), marker in zip(_sides(one), "ox", strict=False):
        axes.plot(rpm, side.misfit.turning, marker, color=colour, markersize=3, fillstyle="none", label=label)
    axes.axhspan(-1.96, 1.96, color=_EXPECTED, zorder=0)
    _standardised_axis(axes)
    axes.set_xlabel("speed of the motor [rpm]")
    axes.set_ylabel("standardised residual\nof the torque [1]")
    axes.set_title(f"{one.held.observed.name}: slow torque of a run that reverses", loc="left", fontsize=8)


def _standardised_axis(axes: Axes) -> None:
    """Scale the axis linearly up to three standard deviations, logarithmically beyond."""
    low, high = axes.get_ylim()
    axes.set_yscale("symlog", linthresh=_LINEAR, linscale=1.5)
    axes.set_ylim(min(1.6 * low, -1.3 * _LINEAR), max(1.6 * high, 1.3 * _LINEAR))
    axes.yaxis.set_major_locator(FixedLocator(_TICKS))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _frequency_axis(axes: Axes, low: float, high: float) -> None:
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_xlabel("frequency [Hz]")
    axes.grid(color=_EXPECTED, linewidth=0.6)
