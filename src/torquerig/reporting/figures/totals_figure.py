"""Bars of the totals of decision tables, one panel a table."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure

from torquerig.reporting.figures.picture import new_figure

BAR = "#5b88ad"


def totals_figure(totals: Mapping[str, Mapping[str, float]]) -> Figure:
    """Return a panel per table with a bar per alternative, the best at the top.

    Parameters
    ----------
    totals : mapping of table to mapping of alternative to total
    """
    most = max((len(one) for one in totals.values()), default=1)
    figure = new_figure(2.5 + 3.0 * max(1, len(totals)), 1.2 + 0.35 * most)
    panels = figure.subplots(1, max(1, len(totals)), squeeze=False)[0]
    for axes, (name, values) in zip(panels, totals.items(), strict=False):
        axes.barh(list(values), list(values.values()), color=BAR)
        axes.invert_yaxis()
        axes.axvline(0.0, color="black", linewidth=0.8)
        axes.set_title(name, fontsize=9)
        axes.set_xlabel("total", fontsize=8)
        axes.tick_params(labelsize=8)
    return figure
