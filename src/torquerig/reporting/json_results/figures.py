"""Figures with interval, unit and origin, as the results of several commands hold them."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.metrics.figure import Figure
from torquerig.reporting.json_results.values import Missing, known


@dataclass(frozen=True)
class FigureResult:
    """A figure: value, lowest and highest value, unit, and its source."""

    value: float | Missing
    low: float | Missing
    high: float | Missing
    unit: str
    source: str


def figure_result(figure: Figure) -> FigureResult:
    """Return a figure; what is not known names the data that are missing."""
    reason = f"not known: {figure.missing}" if figure.missing else "not known"
    certain = figure.low is None and figure.value is not None
    low, high = (figure.value, figure.value) if certain else (figure.low, figure.high)
    value = "only the interval is known" if figure.value is None and figure.low is not None else reason
    return FigureResult(known(figure.value, value), known(low, reason), known(high, reason), figure.unit, figure.source)
