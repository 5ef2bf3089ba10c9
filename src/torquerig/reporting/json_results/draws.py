"""The results of ``torquerig study`` and ``torquerig optimise``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from torquerig.reporting.json_results.values import Interval, Missing, Quantity, known
from torquerig.study.monte_carlo.distribution import distribution, share_uncertainty
from torquerig.study.monte_carlo.drawn_study import DrawnStudy, error_column
from torquerig.study.monte_carlo.lost_draws import LostDraws
from torquerig.study.monte_carlo.running import DesignedDraws, Draws
from torquerig.study.optimisation.search import Optimum
from torquerig.study.optimisation.tried import Tried


@dataclass(frozen=True)
class DrawnCombination:
    """A drive with a filter: share of the draws in which it is best [1], and its reading error (5, 50, 95 %)."""

    drive: str
    filter: str
    best_share: float
    best_share_reach: float
    reading_error: Interval | Missing


@dataclass(frozen=True)
class OpenValue:
    """An open value and its effect on the reading error of a drive; the indices are those of Sobol."""

    drive: str
    filter: str
    value: str
    error: Quantity
    total_reach: float
    total_index: float | Missing
    first_index: float | Missing


@dataclass(frozen=True)
class DecisiveValue:
    """An open value that alone changes which drive is best, in this share of the points [1]."""

    value: str
    share: float
    price: Quantity


@dataclass(frozen=True)
class StudyResult:
    """The distribution of the ranking, or the effects of the open values (``--sensitivity``).

    ``cases``, ``failed`` and ``unfinished`` count the cases of the store; ``rows`` names its tables. ``lost`` has the
    drives with draws that have no figures: how many, and why.
    """

    seed: int
    method: str
    sentence: str
    combinations: tuple[DrawnCombination, ...]
    eliminated: Mapping[str, str]
    not_simulated: Mapping[str, str]
    lost: Mapping[str, LostDraws]
    effects: tuple[OpenValue, ...]
    decisive: tuple[DecisiveValue, ...]
    cases: int
    failed: int
    unfinished: int
    notes: tuple[str, ...]
    rows: str


@dataclass(frozen=True)
class TriedResult:
    """A drive with a filter and a speed loop, and its figures; ``delay`` is null for a filter of whole recordings.

    ``settings`` has the numbers of the filter that were varied, as text with units.
    """

    drive: str
    filter: str
    crossover_Hz: float  # noqa: N815 (the unit in the key)
    integral_corner_Hz: float  # noqa: N815
    reading_error: Quantity
    delay_s: float | Missing
    price: Quantity
    modulus_margin: float
    settings: tuple[str, ...]


@dataclass(frozen=True)
class OptimiseResult:
    """The choices that no other beats in error, delay and price together; and those of the study's rule."""

    seed: int
    motor: str
    sentence: str
    best: tuple[TriedResult, ...]
    by_rule: tuple[TriedResult, ...]
    left_out: Mapping[str, str]
    notes: tuple[str, ...]


def drawn_combinations(drawn: DrawnStudy, found: Draws) -> tuple[DrawnCombination, ...]:
    """Return the combinations by the share of draws in which they are best."""
    drives, draws, unit = list(drawn.drives), len(found.ranking.totals), drawn.study.effort_unit
    made = []
    for (drive, filtering), share in found.ranking.shares().items():
        errors = distribution(found.tables[error_column(filtering)][drives.index(drive)])
        error = (
            Missing("the drive runs in no draw")
            if errors is None
            else Interval(errors.median, errors.low, errors.high, unit)
        )
        made.append(DrawnCombination(drive, filtering, share, share_uncertainty(share, draws), error))
    return tuple(made)


def open_values(found: DesignedDraws, *, unit: str) -> tuple[tuple[OpenValue, ...], tuple[DecisiveValue, ...]]:
    """Return the effects of the open values, and the values that alone change the choice."""
    none = "the method computes no index"
    effects = tuple(
        OpenValue(
            drive=one.drive, filter=one.filtering, value=one.name, error=Quantity(one.error, unit),
            total_reach=one.total_reach, total_index=known(one.total, none), first_index=known(one.first, none),
        )
        for one in found.found.effects
    )  # fmt: skip
    decisive = tuple(
        DecisiveValue(one.name, one.share, Quantity(known(one.price, "a price is not known"), "EUR"))
        for one in found.found.decisive
    )
    return effects, decisive


def optimise_result(
    found: Optimum, best: Sequence[Tried], *, motor: str, seed: int, unit: str, sentence: str, notes: Sequence[str]
) -> OptimiseResult:
    """Return the result of an optimisation."""
    return OptimiseResult(
        seed=seed, motor=motor, sentence=sentence, best=tuple(_tried(one, unit) for one in best),
        by_rule=tuple(_tried(one, unit) for one in found.by_rule), left_out=dict(found.left_out), notes=tuple(notes),
    )  # fmt: skip


def _tried(one: Tried, unit: str) -> TriedResult:
    return TriedResult(
        drive=one.drive, filter=one.filtering, crossover_Hz=one.crossover, integral_corner_Hz=one.integral_corner,
        reading_error=Quantity(one.error, unit), delay_s=known(one.delay, "the filter needs the whole recording"),
        price=Quantity(known(one.price, "a price is not known"), "EUR"), modulus_margin=one.margin,
        settings=one.settings,
    )  # fmt: skip
