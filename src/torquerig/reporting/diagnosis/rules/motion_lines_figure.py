"""Spectral lines in the residuals of both models under measured motion, over position and in frequency."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator

from torquerig.diagnosis.showing.motion_comparison import Scale
from torquerig.diagnosis.showing.motion_lines import LinesCompared, LinesLeft
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE
from torquerig.reporting.diagnosis.rules.motion_panels import AFTER_LABEL, BEFORE_LABEL, GRID
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure

_LABELLED = 12
_APART = 0.05  # [1] least relative distance of two labels
_BELOW = 6.0  # [1] median of the quietest spectrum over the lower end of the axis


def motion_lines_figure(domains: Sequence[LinesCompared], *, scale: Scale) -> Figure:
    """Return a panel per domain: stems of lines and the spectrum between them, before and after."""
    figure = new_figure(10.5, 0.4 + 3.0 * len(domains))
    panels = figure.subplots(len(domains), 1, squeeze=False)[:, 0]
    for axes, one in zip(panels, domains, strict=True):
        _draw(axes, one, scale)
    panels[0].legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    return figure


def _draw(axes: Axes, one: LinesCompared, scale: Scale) -> None:
    models = [(one.before, BEFORE, BEFORE_LABEL)]
    models += [] if one.after is one.before else [(one.after, AFTER, AFTER_LABEL)]
    low = min(float(np.median(left.rest[left.rest > 0])) for left, *_ in models if left.rest.any()) / _BELOW
    axes.set_xscale("log")
    axes.set_yscale("log")
    for (left, colour, label), marker in zip(models, "os", strict=False):
        axes.plot(*envelope(left.places, np.maximum(left.rest, low), columns=500, logarithmic=True), color=colour,
                  linewidth=0.6, alpha=0.6)  # fmt: skip
        _stems(axes, left, colour=colour, label=label, marker=marker, low=low)
    _labels(axes, models)
    tops = [max([*(line.amplitude for line in left.lines), float(left.rest.max())]) for left, *_ in models]
    axes.set_ylim(low, 4 * max(tops))
    axes.set_xlim(float(one.before.places[0]), float(one.before.places[-1]))
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_xlabel(f"cycles over position [{scale.lines}]" if one.domain == "order" else "frequency [Hz]")
    axes.set_ylabel(f"residual amplitude [{scale.effort}]")
    axes.grid(axis="y", color=GRID, linewidth=0.6)


def _stems(axes: Axes, left: LinesLeft, *, colour: str, label: str, marker: str, low: float) -> None:
    at, size = [line.at for line in left.lines], [line.amplitude for line in left.lines]
    axes.vlines(at, low, size, color=colour, linewidth=1.4)
    axes.plot(at, size, marker, color=colour, markersize=4.5, fillstyle="none", label=label)


def _labels(axes: Axes, models: Sequence[tuple[LinesLeft, str, str]]) -> None:
    """Label the strongest lines, one of several that are close together."""
    lines = sorted(
        ((line, colour) for left, colour, _ in models for line in left.lines), key=lambda each: -each[0].amplitude
    )
    written: list[float] = []
    for line, colour in lines:
        if len(written) < _LABELLED and not any(abs(line.at - at) < _APART * at for at in written):
            written.append(line.at)
            axes.annotate(
                f"{line.at:.4g}", (line.at, line.amplitude), xytext=(0, 5), textcoords="offset points", ha="center",
                fontsize=7, color=colour,
            )  # fmt: skip
