"""The least reading error of each drive at the computed points of a sweep."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import nan

from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from torquerig.reporting.figures.effort import shown_unit
from torquerig.reporting.figures.error_figure import COLOURS, SHAPES
from torquerig.reporting.figures.picture import new_figure


def sweep_figure(
    labels: Sequence[str], errors: Mapping[str, Sequence[float | None]], *, x_label: str, unit: str
) -> Figure:
    """Return a line per drive through its computed points.

    Parameters
    ----------
    labels : sequence of str
        Of the points, in their order; their distance on the axis is alike.
    errors : mapping of str to sequence of float or None
        Least reading error at each point by drive; None where the drive was not simulated.
    """
    figure = new_figure(10.5, 4.0)
    axes = figure.add_subplot()
    for place, (drive, found) in enumerate(errors.items()):
        axes.plot(
            range(len(labels)), [nan if one is None else one for one in found],
            marker=SHAPES[place % len(SHAPES)], color=COLOURS[place % len(COLOURS)], linewidth=1.2, markersize=5,
            linestyle=("-", "--", ":")[place // len(COLOURS) % 3], label=drive,
        )  # fmt: skip
    axes.set_xticks(range(len(labels)), list(labels), rotation=30 if len(labels) > 8 else 0)
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel(x_label)
    axes.set_ylabel(f"reading error [{shown_unit(unit)}]")
    axes.grid(axis="y", color="#dde2e7", linewidth=0.6)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=8, frameon=False)
    return figure
