"""Calibration: a confidence of 0.9 must be right nine times in ten."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

BINS = 10


@dataclass(frozen=True)
class ReliabilityRow:
    """One bin of confidences: edges, number of findings, mean confidence ``said``, and share ``right``."""

    low: float
    high: float
    count: int
    said: float
    right: float


@dataclass(frozen=True)
class Calibration:
    """Expected calibration error, Brier score and the reliability table."""

    count: int
    expected_error: float
    brier: float
    table: tuple[ReliabilityRow, ...]


def calibration_of(findings: Iterable[tuple[float, bool]]) -> Calibration | None:
    """Return the calibration in ten bins of equal width; None without findings.

    Source: Guo, Pleiss, Sun and Weinberger 2017, ICML, eq. 3 (expected calibration error); Brier 1950, Monthly Weather
    Review 78(1).
    """
    rows = list(findings)
    if not rows:
        return None
    said, right = np.array([row[0] for row in rows]), np.array([float(row[1]) for row in rows])
    bins = np.minimum((said * BINS).astype(int), BINS - 1)
    table = []
    for i in range(BINS):
        inside = bins == i
        if inside.any():
            low, high = i / BINS, (i + 1) / BINS
            table.append(
                ReliabilityRow(low, high, int(inside.sum()), float(said[inside].mean()), float(right[inside].mean()))
            )
    error = sum(row.count * abs(row.said - row.right) for row in table) / len(rows)
    return Calibration(len(rows), float(error), float(np.mean((said - right) ** 2)), tuple(table))
