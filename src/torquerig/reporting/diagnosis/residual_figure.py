"""What each model leaves of the held-out stretches: the spectrum beside the lines, the lines, the torque at a turn."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator

from torquerig.diagnosis.fitting.misfit import BAND_TOLERANCE
from torquerig.diagnosis.showing.comparison import Compared, Side
from torquerig.reporting.diagnosis.spectrum_figure import AFTER, BEFORE
from torquerig.reporting.figures.picture import new_figure

_DECIBEL = 10 / np.log(10)
_LINEAR = 3.0  # residuals up to so many spreads are drawn on a straight scale
_CHANCE = "#e3e7eb"
_TICKS = (-1000, -300, -100, -30, -10, -3, 0, 3, 10, 30, 100, 300, 1000)


def diagnosis_residual_figure(shown: Compared | None, turning: Sequence[Compared]) -> Figure:
    """Return panels of the residuals: of one run's spectrum and lines, and of the first run that turns back."""
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


def residuals_to_show(shown: Compared | None, turning: Sequence[Compared]) -> bool:
    """Whether there is a spectrum, a line or a turn to draw."""
    return bool(_panels(shown) or turning)


def _panels(shown: Compared | None) -> list[Callable[[Axes, Compared], None]]:
    if shown is None:
        return []
    return [*([_bands] if shown.held.power.size else []), *([_lines] if shown.held.places else [])]


def _sides(one: Compared) -> list[tuple[Side, str, str]]:
    sides = [(one.before, BEFORE, "calibrated model")]
    return sides if one.after is one.before else [*sides, (one.after, AFTER, "with what was found")]


def _bands(axes: Axes, one: Compared) -> None:
    """Draw the density beside the lines over that of each model [dB]; grey is what chance and tolerance leave."""
    held = one.held
    seen = np.where(np.isfinite(held.power) & (held.count > 0), held.count, np.nan)
    spread = 1.96 * _DECIBEL * np.sqrt(1 / seen + BAND_TOLERANCE**2)
    axes.fill_between(held.band, -spread, spread, color=_CHANCE, step="mid", label="chance, 95 %")
    for side, colour, label in _sides(one):
        excess = _DECIBEL * np.log(held.power / side.expected.power)
        axes.step(held.band, excess, where="mid", color=colour, linewidth=1.2, label=label)
    _frequency_axis(axes, float(held.band[0]), float(held.band[-1]))
    axes.set_ylabel("recording over\nmodel [dB]")
    axes.set_title(f"{held.observed.name}: spectrum beside the lines", loc="left", fontsize=8)


def _lines(axes: Axes, one: Compared) -> None:
    """Draw how far each line lies from the model, in units of its spread."""
    at = one.held.line_frequency.mean(axis=(0, 2))
    axes.axhspan(-1.96, 1.96, color=_CHANCE, zorder=0)
    for (side, colour, label), marker in zip(_sides(one), "ox", strict=False):
        residual = np.atleast_2d(side.misfit.lines)
        worst = residual[np.abs(residual).argmax(axis=0), np.arange(residual.shape[1])]
        axes.plot(at, worst, marker, color=colour, markersize=5, fillstyle="none", label=label)
    _spread_axis(axes)
    _frequency_axis(axes, float(at.min()) * 0.8, float(at.max()) * 1.25)
    axes.set_ylabel("residual of each\nline [spreads]")
    axes.set_title(f"{one.held.observed.name}: lines", loc="left", fontsize=8)


def _turning(axes: Axes, one: Compared) -> None:
    blocks = one.held.turning
    if blocks is None:
        return
    rpm = blocks.speed * 30 / np.pi
    for (side, colour, label), marker in zip(_sides(one), "ox", strict=False):
        axes.plot(rpm, side.misfit.turning, marker, color=colour, markersize=3, fillstyle="none", label=label)
    axes.axhspan(-1.96, 1.96, color=_CHANCE, zorder=0)
    _spread_axis(axes)
    axes.set_xlabel("speed of the motor [rpm]")
    axes.set_ylabel("residual torque\n[spreads]")
    axes.set_title(f"{one.held.observed.name}: slow torque while the run turns back", loc="left", fontsize=8)


def _spread_axis(axes: Axes) -> None:
    """Straight up to three spreads, logarithmic beyond."""
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
    axes.grid(color=_CHANCE, linewidth=0.6)
