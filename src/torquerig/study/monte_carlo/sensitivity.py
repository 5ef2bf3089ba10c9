"""Which open value drives the reading error of each drive, and which one decides the choice."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.study.monte_carlo.design import LEVELS, Design
from torquerig.study.monte_carlo.drawn_study import error_column
from torquerig.study.monte_carlo.ranking import Ranking

Floats = NDArray[np.float64]
RESAMPLES = 200  # bootstrap samples of an index


@dataclass(frozen=True)
class ValueEffect:
    """The effect of one open value on the reading error of one drive behind its best filter.

    Parameters
    ----------
    drive, filtering, name : str
    first, total : float or None
        Sobol indices [1]: the share of the variance by this value alone, and with all its interactions; None for
        Morris.
    total_reach : float
        Half-width of the 95 % interval of ``total``; for Morris of ``error`` [unit of the error].
    error : float
        What it makes of the reading error [N m]: for Sobol the standard deviation that vanishes with it,
        ``sqrt(total) * sd``; for Morris the mean absolute elementary effect over the whole range.
    """

    drive: str
    filtering: str
    name: str
    first: float | None
    total: float | None
    total_reach: float
    error: float


@dataclass(frozen=True)
class Decisive:
    """How often one open value alone changes which drive is best.

    Parameters
    ----------
    name : str
    share : float
        Of the base points: another value of it, all else equal, makes another drive the best [1].
    price : float or None
        Mean difference of the prices of the two drives where that happens [EUR]; None where a price is unknown.
    """

    name: str
    share: float
    price: float | None


@dataclass(frozen=True)
class Sensitivity:
    """Effects of all open values, the largest first, and the decisive ones."""

    effects: tuple[ValueEffect, ...]
    decisive: tuple[Decisive, ...]
    points: int


def sensitivity(
    design: Design, tables: Mapping[str, Floats], ranking: Ranking, *,
    prices: Mapping[str, float | None],
) -> Sensitivity:  # fmt: skip
    """Return the effects on the ranked drives, from the tables of a design, shape (drives, rows), and its ranking.

    ``prices`` are those of the new parts of each drive [EUR].
    """
    best_filters, found = ranking.best_filters(), []
    for at, drive in enumerate(design.of_drive):
        if design.of_drive[drive] and drive in best_filters:  # nobody need ask for data of the eliminated
            filtering = best_filters[drive]
            found += _effects(design, drive, filtering, tables[error_column(filtering)][at])
    decisive = _decisive(design, ranking, prices) if design.method == "sobol" else ()
    return Sensitivity(tuple(sorted(found, key=lambda one: -one.error)), decisive, _points(design))


def _effects(design: Design, drive: str, filtering: str, values: Floats) -> list[ValueEffect]:
    missing = int(np.isnan(values).sum())
    if missing:
        raise InputError(
            f"{drive} has no reading error in {missing} of {values.size} rows of the design (see the columns error and "
            "out_of_reach of the store); leave the drive out with --set study.motors=[...]"
        )
    wanted = set(design.of_drive[drive])
    if float(values.std()) == 0.0:
        return []
    if design.method == "morris":
        from SALib.analyze import morris

        made = morris.analyze(
            design.problem, design.quantiles, values, num_levels=LEVELS, num_resamples=RESAMPLES, seed=0
        )
        rows = zip(design.names, made["mu_star"], made["mu_star_conf"], strict=True)
        return [
            ValueEffect(drive, filtering, name, None, None, float(reach), float(effect))
            for name, effect, reach in rows if name in wanted
        ]  # fmt: skip
    from SALib.analyze import sobol

    made = sobol.analyze(design.problem, values, calc_second_order=False, num_resamples=RESAMPLES, seed=0)
    spread = float(values.reshape(_points(design), -1)[:, [0, -1]].std())  # of the rows A and B
    return [
        ValueEffect(drive, filtering, name, float(first), float(total), float(reach),
                    spread * float(np.sqrt(max(0.0, total))))
        for name, first, total, reach in zip(design.names, made["S1"], made["ST"], made["ST_conf"], strict=True)
        if name in wanted
    ]  # fmt: skip


def _decisive(design: Design, ranking: Ranking, prices: Mapping[str, float | None]) -> tuple[Decisive, ...]:
    """Return the share of base points in which the best drive changes with one value (rows A against AB_i)."""
    drives = list(dict.fromkeys(drive for drive, _ in ranking.combinations))
    of_combination = np.array([drives.index(drive) for drive, _ in ranking.combinations])
    best = of_combination[ranking.best].reshape(_points(design), -1)
    costs = np.array([np.nan if prices.get(drive) is None else prices[drive] for drive in drives], dtype=float)
    found = []
    for column, name in enumerate(design.names, start=1):
        changed = best[:, column] != best[:, 0]
        by = np.abs(costs[best[changed, column]] - costs[best[changed, 0]])
        price = float(by.mean()) if by.size and not np.isnan(by).any() else None
        found.append(Decisive(name, float(changed.mean()), price))
    return tuple(sorted(found, key=lambda one: -one.share))


def _points(design: Design) -> int:
    count = len(design.names)
    return len(design.quantiles) // (count + 2 if design.method == "sobol" else count + 1)
