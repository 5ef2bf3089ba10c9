"""Shares of the sensor's reading, a stacked bar per drive."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from torquerig.reporting.figures.effort import shown_unit
from torquerig.reporting.figures.picture import new_figure
from torquerig.reporting.figures.shades import SHARES
from torquerig.study.results import DriveResult


def shares_figure(drives: Sequence[DriveResult]) -> Figure:
    """Return bars of the shares of the fluctuation's power [%], and the rms of each share [N m]."""
    run = [drive for drive in drives if drive.shares is not None][::-1]
    figure = new_figure(10.5, 1.2 + 0.22 * len(run))
    percent, rms = figure.subplots(1, 2, sharey=True, width_ratios=(3, 2))
    left = [0.0] * len(run)
    for name, colour in SHARES.items():
        widths = [drive.shares.percent()[name] for drive in run if drive.shares]
        percent.barh(range(len(run)), widths, left=left, color=colour, label=name, height=0.72)
        left = [start + width for start, width in zip(left, widths, strict=True)]
        values = [getattr(drive.shares, name) for drive in run]
        rms.plot(values, range(len(run)), "o", color=colour, markersize=4)
    percent.set_yticks(range(len(run)), [drive.candidate.name for drive in run])
    percent.set_ylim(-0.6, len(run) - 0.4)
    percent.set_xlim(0, 100)
    percent.set_xlabel("share of the fluctuation's power [%]")
    rms.set_xlim(left=0)
    unit = shown_unit(run[0].disturbance.unit) if run else "N m"
    rms.set_xlabel(f"rms at the sensor [{unit}]")
    rms.grid(color="#e3e7eb", linewidth=0.6)
    percent.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=4, fontsize=8, frameon=False)
    return figure
