"""The ranking of all combinations at each draw, and the share of draws in which each is best."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.eliminate import ChartRow, Decision, Mark, eliminate
from torquerig.decide.kesselring import TEACHING, KesselringResult, kesselring
from torquerig.decide.matrix import Cell, DecisionMatrix
from torquerig.study.candidates import scenario_of
from torquerig.study.criteria import criteria_of, requirements_of
from torquerig.study.monte_carlo.drawn_study import DrawnStudy, error_column, residual_column
from torquerig.study.planned_drive import planned_drive
from torquerig.study.results import DriveResult
from torquerig.study.scoring import cell_of, figure_of
from torquerig.study.settings import SIMULATED, Metric

if TYPE_CHECKING:
    import pandas as pd

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Ranking:
    """The totals of the combinations of all drives that no requirement eliminates.

    Parameters
    ----------
    combinations : tuple of (drive, filter)
    totals : ndarray, shape (draws, combinations)
        Weighted points T over their largest value [1]; -inf where a drive cannot run at a draw.
    eliminated : mapping of str to str
        Drives that a requirement eliminates, with its name.
    """

    combinations: tuple[tuple[str, str], ...]
    totals: Floats
    eliminated: Mapping[str, str]

    @property
    def is_empty(self) -> bool:
        """Whether no combination has a reading at any draw."""
        return not np.isfinite(self.totals).any()

    @property
    def best(self) -> NDArray[np.int64]:
        """The best combination of each draw, shape (draws,); the first listed where several are."""
        return np.asarray(self.totals.argmax(axis=1), dtype=np.int64)

    def shares(self) -> dict[tuple[str, str], float]:
        """Return the share of draws in which each combination is best, the largest first."""
        counts = np.bincount(self.best, minlength=len(self.combinations)) / len(self.totals)
        found = dict(zip(self.combinations, counts.tolist(), strict=True))
        return dict(sorted(found.items(), key=lambda item: -item[1]))

    def best_filters(self) -> dict[str, str]:
        """Return for each drive the filter with the largest mean total over the draws in which it can run."""
        runs = np.isfinite(self.totals)
        means = np.where(runs, self.totals, 0.0).sum(axis=0) / np.maximum(1, runs.sum(axis=0))
        found: dict[str, str] = {}
        for at in np.argsort(-means, kind="stable"):
            drive, filtering = self.combinations[at]
            found.setdefault(drive, filtering)
        return found

    def drive_shares(self) -> dict[str, float]:
        """Return the share of draws in which each drive is best with any filter, the largest first."""
        found: dict[str, float] = {}
        for (drive, _), share in self.shares().items():
            found[drive] = found.get(drive, 0.0) + share
        return dict(sorted(found.items(), key=lambda item: -item[1]))


@dataclass(frozen=True)
class Rating:
    """What the points of a study are made of: fixed for criteria that no draw changes, by value for the simulated.

    Criteria that rest on the catalog alone have the points of their stated value, or of the middle of their interval.
    ``prices`` are those of the new parts of each drive [EUR], None where unknown.
    """

    drawn: DrawnStudy
    matrix: DecisionMatrix
    fixed: KesselringResult
    eliminated: Mapping[str, str]
    prices: Mapping[str, float | None]

    def ranking(self, tables: Mapping[str, Floats]) -> Ranking:
        """Return the ranking at each draw.

        Parameters
        ----------
        tables : mapping of str to ndarray, shape (drives, draws)
            The values of each simulated column, NaN where a drive cannot run; drives in the order of the study.
        """
        rows, drives = self._combinations(), list(self.drawn.drives)
        draws = next(iter(tables.values())).shape[1]
        totals = np.zeros((draws, len(rows)))
        criteria = {one.name: one for one in self.matrix.criteria}
        for column, name in enumerate(self.fixed.criteria):
            metric, weight = self.drawn.study.settings.criteria[name].metric, self.fixed.normalised[column]
            value = criteria[name].value
            for at, (drive, filtering) in enumerate(rows):
                if metric not in SIMULATED or value is None:
                    totals[:, at] += weight * self.fixed.middle[at, column]
                    continue
                values = tables[column_of(metric, filtering)][drives.index(drive)]
                totals[:, at] += weight * value.points(values)
        totals = np.where(np.isnan(totals), -np.inf, totals / self.fixed.profile.p_max)
        return Ranking(rows, totals, self.eliminated)

    def _combinations(self) -> tuple[tuple[str, str], ...]:
        return tuple(_parted(name) for name in self.matrix.alternatives)


def rating_of(drawn: DrawnStudy) -> Rating:
    """Return what the study's criteria make of the drives before any draw; InputError for unusable criteria."""
    study, results = drawn.study, {}
    alone = replace(study, settings=study.settings.model_copy(update={"draws": 0}))
    for name, candidate in drawn.drives.items():
        scenario = scenario_of(candidate, study, seed=study.settings.seed)
        results[name] = planned_drive(candidate, scenario, alone).result
    chart = eliminate(
        DecisionMatrix(
            name="requirements",
            alternatives=tuple(results),
            criteria=requirements_of(study),
            cells={
                (name, key): _cell(result, None, row.metric)
                for name, result in results.items()
                for key, row in study.settings.requirements.items()
            },
        )
    )
    failed = {row.alternative: row for row in chart.rows if row.decision is Decision.ELIMINATE}
    rows = {(name, one): result for name, result in results.items() if name not in failed for one in drawn.filters}
    matrix = DecisionMatrix(
        name="criteria",
        alternatives=tuple(_joined(*pair) for pair in rows),
        criteria=criteria_of(study),
        cells={
            (_joined(*pair), key): _cell(result, pair[1], row.metric)
            for pair, result in rows.items()
            for key, row in study.settings.criteria.items()
        },
    )
    prices = {name: result.margins["price"].value for name, result in results.items()}
    reasons = {name: _why(row) for name, row in failed.items()}
    return Rating(drawn, matrix, kesselring(matrix, profile=TEACHING), reasons, prices)


def column_of(metric: str, filtering: str) -> str:
    """Return the column of a simulated metric behind a filter."""
    behind = {"truth_error": error_column, "residual_disturbance": residual_column}
    return behind[metric](filtering) if metric in behind else metric


def tables_of(drawn: DrawnStudy, rows: pd.DataFrame) -> dict[str, Floats]:
    """Return each float column of the stored rows as a table, shape (drives, draws); NaN where there is no value."""
    names = list(drawn.drives)
    columns = [column.name for column in drawn.results() if column.kind == "float"]
    draws = int(rows["draw"].max()) + 1 if len(rows) else 0
    at = rows["drive"].map({name: row for row, name in enumerate(names)}).to_numpy(), rows["draw"].to_numpy()
    tables = {}
    for column in columns:
        table = np.full((len(names), draws), np.nan)
        table[at] = rows[column].to_numpy(dtype=float)
        tables[column] = table
    return tables


def _joined(drive: str, filtering: str) -> str:
    return f"{drive} | {filtering}"


def _parted(name: str) -> tuple[str, str]:
    drive, _, filtering = name.rpartition(" | ")
    return drive, filtering


def _cell(result: DriveResult, filtering: str | None, metric: Metric) -> Cell:
    """Return the cell of a criterion that no draw changes; those of simulated figures are filled draw by draw."""
    if metric in SIMULATED:
        return Cell(unknown_reason=f"simulated {metric.replace('_', ' ')}")
    figure = figure_of(result, filtering, metric)
    cell = cell_of(figure)
    return cell if cell.known else replace(cell, unknown_reason=cell.unknown_reason or metric.replace("_", " "))


def _why(row: ChartRow) -> str:
    return next(remark.rule for remark in row.remarks if remark.mark is Mark.FAILS)
