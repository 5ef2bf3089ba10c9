"""Figures: reliability of the confidence, and gains on rigs without hidden effects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure

from torquerig.reporting.figures.picture import new_figure

INK, GRID = "#12395b", "#c6ccd2"
_LINEAR = 10.0  # gain below which the axis of gains is linear


def reliability_figure(rows: Sequence[tuple[float, float, int]]) -> Figure:
    """Return the reliability diagram; ``rows`` are (mean confidence, share right, number) of each bin."""
    figure = new_figure(5.2, 4.4)
    axes = figure.add_subplot()
    axes.plot([0, 1], [0, 1], "--", color=GRID, linewidth=1.0, zorder=1)
    most = max((count for *_, count in rows), default=1)
    for confidence, right, count in rows:
        axes.plot(confidence, right, "o", color=INK, markersize=4 + 12 * np.sqrt(count / most), alpha=0.8, zorder=2)
        axes.annotate(str(count), (confidence, right), xytext=(8, -8), textcoords="offset points", fontsize=8)
    axes.set(xlim=(0, 1.02), ylim=(-0.02, 1.04), aspect="equal", xlabel="stated confidence",
             ylabel="share of right findings")  # fmt: skip
    return figure


def gains_figure(gains: Mapping[str, Sequence[float]], *, least: float, thresholds: Mapping[str, float]) -> Figure:
    """Return the gains per clean rig and mechanism, with the built-in and the derived thresholds.

    Parameters
    ----------
    gains : mapping of str to sequence of float
        Gains of the best fit to each clean rig, by mechanism.
    least : float
        The built-in threshold, the same for every mechanism.
    thresholds : mapping of str to float
        Derived from the gains, by mechanism.
    """
    names = sorted(gains, key=lambda name: max(gains[name], default=0.0))
    figure = new_figure(9.0, 1.4 + 0.32 * len(names))
    axes = figure.add_subplot()
    for row, name in enumerate(names):
        axes.plot(gains[name], [row] * len(gains[name]), "o", color=INK, markersize=4, alpha=0.5, zorder=2)
        if name in thresholds:
            axes.plot([thresholds[name]] * 2, [row - 0.35, row + 0.35], color="#b3261e", linewidth=2.0, zorder=3)
    axes.axvline(least, color="#5d7488", linestyle="--", linewidth=1.0, zorder=1)
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(-0.6, len(names) - 0.4)
    axes.set_xscale("symlog", linthresh=_LINEAR)
    axes.set_xlabel("gain: fall of chi-square [1]")
    axes.grid(axis="x", color="#e3e7eb", linewidth=0.6)
    axes.set_axisbelow(True)
    return figure
