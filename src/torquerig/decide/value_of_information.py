"""Value of information: how much each missing fact would improve the choice, the most useful first."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.criterion import YES_NO, Criterion
from torquerig.decide.eliminate import Decision, eliminate
from torquerig.decide.kesselring import TEACHING, KesselringResult, Profile, kesselring
from torquerig.decide.monte_carlo import points_over, value_at, values_over
from torquerig.decide.ranks import TIE

if TYPE_CHECKING:
    from torquerig.decide.matrix import Cell, DecisionMatrix

STEPS = 1000  # values of an open fact over its interval; a share below 0.1 % of the interval is not resolved

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class DecisiveRange:
    """The part of the interval of a fact in which another alternative wins.

    Parameters
    ----------
    winner : str
        Empty where no alternative would meet the requirements.
    low, high : float
        Ends of this part, in the first of the fact's cells [unit of the criterion; points where nothing is known].
    """

    winner: str
    low: float
    high: float


@dataclass(frozen=True, kw_only=True)
class MissingFact:
    """One missing fact, and the value of knowing it.

    Parameters
    ----------
    fact : str
        Name of the fact.
    cells : tuple of (alternative, criterion)
        The cells that depend on it.
    unit : str
        The unit of the ranges; ``points`` where nothing is known of the value.
    p_change : float
        Probability that the winner changes when the fact is sampled from its interval and all else is held [1].
    gain : float
        Mean improvement of the choice, in T/T_max [1]: the expected value of perfect information.
    ranges : tuple of DecisiveRange
        The parts of its interval in which another alternative wins.
    rule : str
        The requirement that the fact decides, where nothing is known of it and it gives no points.
    """

    fact: str
    cells: tuple[tuple[str, str], ...]
    unit: str
    p_change: float
    gain: float
    ranges: tuple[DecisiveRange, ...]
    rule: str = ""

    @property
    def decisive(self) -> bool:
        """Whether the fact alone can change the winner."""
        return self.p_change > 0

    def sentence(self) -> str:
        """Return the question to the maker, and its effect, as one sentence."""
        question = f"ask the maker {'' if self.fact.startswith('whether ') else 'for the '}{self.fact}"
        if not self.ranges:
            return f"{question}: alone it cannot change the winner"
        if self.rule:
            broken = "if not" if self.fact.startswith("whether ") else f"if it breaks the requirement ({self.rule})"
            return f"{question}: {broken}, {self.ranges[0].winner or 'no alternative'} wins"
        winners = ", ".join(
            f"{one.winner or 'no alternative'} wins {_range_text(one, self.unit)}".replace("  ", " ")
            for one in self.ranges
        )
        return f"{question}: {winners} ({self.p_change:.0%} of its range)"


def missing_facts(matrix: DecisionMatrix, *, profile: Profile = TEACHING) -> tuple[MissingFact, ...]:
    """Return every open fact of a matrix, those first that improve the choice most.

    One fact takes every value of its interval in turn while all others keep their middle; the cells that depend on it
    move together. A value that violates a requirement eliminates the alternative (T = 0). Where nothing is known of a
    required value, it meets the requirement in half of all cases. The gain is the mean of ``max T - T of the present
    winner`` over these values, the expected value of partial perfect information (Howard, Information value theory,
    IEEE Transactions on Systems Science and Cybernetics 2 (1966) 22-26). Two facts that change the winner only together
    have no gain here.
    """
    chart = eliminate(matrix)
    out = set(chart.with_decision(Decision.ELIMINATE))
    remaining = [name for name in matrix.alternatives if name not in out]
    if not remaining:
        return ()
    kept = matrix.only(alternatives=remaining)
    result = kesselring(kept, profile=profile)
    found = [_missing_fact(kept, result, name, cells) for name, cells in _open_facts(kept).items()]
    return tuple(sorted(found, key=lambda one: (-one.gain, -one.p_change, one.fact)))


def _open_facts(matrix: DecisionMatrix) -> dict[str, list[tuple[int, Criterion]]]:
    facts: dict[str, list[tuple[int, Criterion]]] = {}
    for row, alternative in enumerate(matrix.alternatives):
        for criterion in matrix.criteria:
            cell = matrix.cell(alternative, criterion.name)
            matters = criterion.weight > 0 or not criterion.wish
            if matters and not cell.known and cell.points_by_hand is None:
                facts.setdefault(fact_of(cell, alternative, criterion), []).append((row, criterion))
    return facts


def fact_of(cell: Cell, alternative: str, criterion: Criterion) -> str:
    """Return the name of the missing fact of an open cell, in words that follow "the"."""
    return (cell.fact or cell.unknown_reason or f"{criterion.name} of {alternative}").removeprefix("the ")


def _missing_fact(
    matrix: DecisionMatrix, result: KesselringResult, name: str, cells: list[tuple[int, Criterion]]
) -> MissingFact:
    totals = np.repeat(result.total[:, None], STEPS, axis=1)
    allowed = np.ones(totals.shape, np.bool_)
    shares = (np.arange(STEPS) + 0.5) / STEPS
    for row, criterion in cells:
        cell = matrix.cell(matrix.alternatives[row], criterion.name)
        if criterion.weight > 0:
            points = points_over(cell, criterion, result.profile, shares)
            middle = result.middle[row, result.criteria.index(criterion.name)]
            totals[row] += criterion.weight * (points - middle)
        if not criterion.wish:
            allowed[row] &= _meets(cell, criterion, shares)
    totals = np.where(allowed, totals, 0.0)
    base = int(np.argsort(-result.total, kind="stable")[0])
    best = np.where(totals[base] >= totals.max(axis=0) - TIE, base, totals.argmax(axis=0))
    best = np.where(allowed.any(axis=0), best, -1)
    first, shown = cells[0]
    cell = matrix.cell(matrix.alternatives[first], shown.name)
    asks = cell.unknown and shown.requirement is not None and not any(criterion.weight > 0 for _, criterion in cells)
    return MissingFact(
        fact=name,
        cells=tuple((matrix.alternatives[row], criterion.name) for row, criterion in cells),
        unit="points" if cell.unknown else shown.unit,
        p_change=float((best != base).mean()),
        gain=float((totals.max(axis=0) - totals[base]).mean()) / result.ideal,
        ranges=_ranges(result, best, base, cell),
        rule=shown.requirement.rule(shown.name, shown.unit) if asks and shown.requirement is not None else "",
    )


def _meets(cell: Cell, criterion: Criterion, shares: Array) -> NDArray[np.bool_]:
    requirement = criterion.requirement
    if requirement is None or requirement.in_question:
        return np.ones(shares.size, np.bool_)
    if cell.unknown:
        return np.asarray(shares >= 0.5)
    values = values_over(cell, shares)
    low, high = (
        (-np.inf if requirement.low is None else requirement.low),
        (np.inf if requirement.high is None else requirement.high),
    )
    return np.asarray((values >= low) & (values <= high))


def _ranges(result: KesselringResult, best: NDArray[np.int64], base: int, cell: Cell) -> tuple[DecisiveRange, ...]:
    """Return the parts of the interval with one and the same other winner."""
    edges = [0, *(np.flatnonzero(np.diff(best)) + 1).tolist(), best.size]
    ranges = []
    for start, stop in pairwise(edges):
        if best[start] == base:
            continue
        if cell.unknown:
            span = result.profile.p_max - result.profile.p_min
            low, high = (result.profile.p_min + span * edge / STEPS for edge in (start, stop))
        else:
            low, high = (value_at(cell, edge / STEPS) for edge in (start, stop))
        winner = "" if best[start] < 0 else result.alternatives[int(best[start])]
        ranges.append(DecisiveRange(winner=winner, low=low, high=high))
    return tuple(ranges)


def _range_text(found: DecisiveRange, unit: str) -> str:
    if unit == YES_NO:
        return ""
    suffix = "" if unit == "1" else f" {unit}"
    return f"from {found.low:.3g} to {found.high:.3g}{suffix}"
