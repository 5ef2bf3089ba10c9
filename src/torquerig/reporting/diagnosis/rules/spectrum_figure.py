"""Spectra of recording and models over the orders of the output shaft, with lines labelled by label."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator
from numpy.typing import NDArray

from torquerig.diagnosis.showing.comparison import Compared
from torquerig.diagnosis.showing.comparison_curves import order_spectrum
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE, RECORDED
from torquerig.reporting.diagnosis.rules.line_labels import KNOWN, LineLabel
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure

Floats = NDArray[np.float64]

_DECADES = 5.0  # below the highest peak
_LABEL_STEP = 0.021  # [1] least distance of two labels, as a share of the axis
_MOST_LABELS = 40


def diagnosis_spectrum_figure(shown: Compared, labels: Sequence[LineLabel], *, ratio: float) -> Figure:
    """Return amplitudes over output orders: the recording with the model before, and below with the model after."""
    alone = shown.after is shown.before
    figure = new_figure(10.5, 4.6 if alone else 7.0)
    panels = figure.subplots(1 if alone else 2, 1, sharex=True, sharey=True, squeeze=False)[:, 0]
    recorded = order_spectrum(shown.held.observed, shown.held, ratio=ratio)
    low, top = 0.3, min(1.4 * max((label.order for label in labels), default=100.0), float(recorded[0][-1]) * 0.9)
    sides = [(shown.before, BEFORE, "calibrated model")]
    sides += [] if alone else [(shown.after, AFTER, "model with findings")]
    peak = float(recorded[1][recorded[0] >= low].max())
    for axes, (side, colour, label) in zip(panels, sides, strict=True):
        modelled = order_spectrum(side.copy, shown.held, ratio=ratio)
        axes.plot(*_within(recorded, low, top), color=RECORDED, linewidth=1.1, label="recording")
        axes.plot(*_within(modelled, low, top), color=colour, linewidth=0.6, label=label)
        _scales(axes, low=low, top=top, peak=peak)
        for line in labels:
            axes.axvline(line.order, color=line.colour, linewidth=0.6, alpha=0.35, zorder=0.5)
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    _label(panels[0], [label for label in labels if low <= label.order <= top])
    panels[-1].set_xlabel("order of the output shaft [1/rev]")
    return figure


def _within(curve: tuple[Floats, Floats], low: float, top: float) -> tuple[Floats, Floats]:
    orders, amplitudes = curve
    kept = (orders >= low) & (orders <= top)
    return envelope(orders[kept], amplitudes[kept], columns=600, logarithmic=True)


def _scales(axes: Axes, *, low: float, top: float, peak: float) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(low, top)
    axes.set_ylim(peak * 10**-_DECADES, peak * 300)
    axes.set_yticks(
        [10.0**power for power in range(int(np.floor(np.log10(peak) - _DECADES)) + 1, int(np.ceil(np.log10(peak))) + 1)]
    )
    axes.yaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_ylabel("amplitude [N m]")
    axes.grid(axis="y", color="#e3e7eb", linewidth=0.6)


def _label(axes: Axes, labels: Sequence[LineLabel]) -> None:
    """Write upright labels at the top; of too many, those of known lines are omitted first."""
    ranked = sorted(labels, key=lambda label: label.colour == KNOWN)[:_MOST_LABELS]
    low, high = np.log(axes.get_xlim())
    last = -1.0
    for label in sorted(ranked, key=lambda label: label.order):
        last = max((np.log(label.order) - low) / (high - low), last + _LABEL_STEP)
        axes.text(
            last, 0.985, f"{label.text}  {label.order:.4g}", transform=axes.transAxes, rotation=90, va="top",
            ha="center", fontsize=7, color=label.colour, fontweight="normal" if label.colour == KNOWN else "bold",
            bbox={"facecolor": "white", "alpha": 0.75, "edgecolor": "none", "pad": 0.4},
        )  # fmt: skip
