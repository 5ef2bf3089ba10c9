"""How far off the parameters of what was named are, and whether the interval covers the truth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from proof.scoring.outcome import Match


@dataclass(frozen=True)
class ParameterError:
    """Relative error of one parameter; ``covered`` is None without an interval."""

    mechanism: str
    name: str
    first_named: bool
    error: float
    covered: bool | None


@dataclass(frozen=True)
class ErrorFigures:
    """Number of estimates, median and 90 % quantile of the relative error, share of intervals with the true value."""

    count: int
    median: float
    p90: float
    covered: float | None


def errors_of(match: Match) -> list[ParameterError]:
    """Return the errors of the parameters that truth and finding both state; an order counts like any parameter.

    A parameter that truly has no value (the time constant of a linear drift) is right if it is given none, and wrong by
    all of it if it is given one.
    """
    if match.effect is None or match.by_class:
        return []
    rows = []
    stated = dict(match.finding.parameters)
    for i, (name, true) in enumerate(match.effect.parameters.items()):
        if name not in stated:
            continue
        value, interval = stated[name].value, stated[name].interval
        if true is None or value is None:
            rows.append(ParameterError(match.effect.mechanism, name, i == 0, float(true is not value), None))
            continue
        covered = None if interval is None else interval[0] <= true <= interval[1]
        rows.append(ParameterError(match.effect.mechanism, name, i == 0, abs(value / true - 1.0), covered))
    return rows


def figures(errors: Iterable[ParameterError]) -> ErrorFigures | None:
    """Return the statistics of errors, or None without errors."""
    rows = list(errors)
    if not rows:
        return None
    sizes = np.array([row.error for row in rows])
    known = [row.covered for row in rows if row.covered is not None]
    return ErrorFigures(
        count=len(rows),
        median=float(np.median(sizes)),
        p90=float(np.quantile(sizes, 0.9)),
        covered=sum(known) / len(known) if known else None,
    )
