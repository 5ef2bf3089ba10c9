"""The numbers of a study's pictures as CSV text, for the page to save."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.reporting.study.csv_tables import csv_text

if TYPE_CHECKING:
    from torquerig.filters.filter_effect import FilterEffect
    from torquerig.study.results import StudyRuns
    from torquerig.study.scoring import Decided


def errors_csv(runs: StudyRuns) -> str:
    """Return the reading error of each drive with each filter, with its extremes over the samples."""
    rows = []
    for drive in runs.drives:
        for name, chain in drive.chains.items():
            error = chain.truth_error
            ends = {"": error.value, " low": error.low, " high": error.high}
            numbers = [(f"reading error{end} [{error.unit}]", _number(value)) for end, value in ends.items()]
            rows.append([("drive", drive.candidate.name), ("filter", name), *numbers])
    return csv_text(rows)


def ratings_csv(decided: Decided) -> str:
    """Return technical and economic rating of each combination."""
    assert decided.economic is not None
    pairs = zip(
        decided.technical.alternatives,
        decided.technical.share.tolist(),
        decided.economic.share.tolist(),
        strict=True,
    )
    return csv_text(
        [
            [("combination", name), ("technical rating [1]", _number(x)), ("economic rating [1]", _number(y))]
            for name, x, y in pairs
        ]
    )


def levels_csv(effect: FilterEffect, *, unit: str) -> str:
    """Return the amplitude of each notched line before and after a filter."""
    from torquerig.orders.kinematics.order_report_text import name_of

    return csv_text(
        [
            [
                ("line", name_of(level.line)), ("frequency [Hz]", _number(level.frequency)),
                (f"before [{unit}]", _number(level.before)), (f"after [{unit}]", _number(level.after)),
            ]
            for level in effect.levels
        ]
    )  # fmt: skip


def _number(value: float | None) -> str:
    return "?" if value is None else f"{value:.6g}"
