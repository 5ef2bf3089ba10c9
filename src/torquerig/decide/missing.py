"""Which missing datum to get next: what each would change if it were known, the most useful first."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.criterion import YES_NO, Criterion
from torquerig.decide.draws import points_at, value_at
from torquerig.decide.eliminate import Decision, eliminate
from torquerig.decide.kesselring import TEACHING, KesselringResult, Profile, kesselring
from torquerig.decide.matrix import Cell, DecisionMatrix
from torquerig.decide.ranks import TIE

STEPS = 1000  # values that an open fact is given in turn; the law is exact between the knots of its value function

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Turn:
    """From where to where in its interval a fact makes another one win.

    Parameters
    ----------
    winner : str
        Empty where nobody would be left.
    low, high : float
        Ends of the stretch, in the first of the fact's cells [unit of the criterion; points where nothing is known].
    """

    winner: str
    low: float
    high: float


@dataclass(frozen=True, kw_only=True)
class MissingFact:
    """One fact that nobody has stated, and what it is worth to know it.

    Parameters
    ----------
    fact : str
        What to ask for.
    cells : tuple of (alternative, criterion)
        The cells that rest on it.
    unit : str
        The unit of the turns; ``points`` where nothing is known of the value.
    p_change : float
        How often the winner is another one when the fact is drawn from its interval and all else is held [1].
    gain : float
        By how much the choice then improves on average, in T/T_max [1]: the expected value of perfect information.
    turns : tuple of Turn
        The stretches of its interval in which the winner is another one.
    rule : str
        The demand that it answers, where nothing is known of it and it gives no points: a question with yes or no.
    """

    fact: str
    cells: tuple[tuple[str, str], ...]
    unit: str
    p_change: float
    gain: float
    turns: tuple[Turn, ...]
    rule: str = ""

    @property
    def decisive(self) -> bool:
        """Whether the fact alone can change the winner."""
        return self.p_change > 0

    def sentence(self) -> str:
        """Return what to ask, and why, as one sentence."""
        asked = f"ask the maker {'' if self.fact.startswith('whether ') else 'for the '}{self.fact}"
        if not self.turns:
            return f"{asked}: alone it cannot change the winner"
        if self.rule:
            broken = "if not" if self.fact.startswith("whether ") else f"if it breaks the demand ({self.rule})"
            return f"{asked}: {broken}, {self.turns[0].winner or 'nobody'} wins"
        told = ", ".join(
            f"{one.winner or 'nobody'} wins {_stretch(one, self.unit)}".replace("  ", " ") for one in self.turns
        )
        return f"{asked}: {told} ({self.p_change:.0%} of its range)"


def missing_facts(matrix: DecisionMatrix, *, profile: Profile = TEACHING) -> tuple[MissingFact, ...]:
    """Return every open fact of a matrix, those first that improve the choice most.

    One fact is given every value of its interval in turn while all others keep their middle; those that rest on several
    cells move together. A demand that the value would break takes the alternative out (as worth nothing), and where
    nothing is known of a demanded value, it is met in the better half of all cases. The gain is the mean of
    ``max T - T of the present winner`` over these values, the expected value of partial perfect information (Howard,
    Information value theory, IEEE Transactions on Systems Science and Cybernetics 2 (1966) 22-26). Two facts that only
    together change the winner get no gain here.
    """
    chart = eliminate(matrix)
    out = set(chart.with_decision(Decision.ELIMINATE))
    left = [name for name in matrix.alternatives if name not in out]
    if not left:
        return ()
    rest = matrix.only(alternatives=left)
    result = kesselring(rest, profile=profile)
    found = [_weighed(rest, result, name, cells) for name, cells in _open(rest).items()]
    return tuple(sorted(found, key=lambda one: (-one.gain, -one.p_change, one.fact)))


def _open(matrix: DecisionMatrix) -> dict[str, list[tuple[int, Criterion]]]:
    facts: dict[str, list[tuple[int, Criterion]]] = {}
    for row, alternative in enumerate(matrix.alternatives):
        for criterion in matrix.criteria:
            cell = matrix.cell(alternative, criterion.name)
            asked = criterion.weight > 0 or not criterion.wish
            if asked and not cell.known and cell.points_by_hand is None:
                facts.setdefault(fact_of(cell, alternative, criterion), []).append((row, criterion))
    return facts


def fact_of(cell: Cell, alternative: str, criterion: Criterion) -> str:
    """Return what to ask for where a cell is open, in words that follow "the"."""
    return (cell.fact or cell.unknown_reason or f"{criterion.name} of {alternative}").removeprefix("the ")


def _weighed(
    matrix: DecisionMatrix, result: KesselringResult, name: str, cells: list[tuple[int, Criterion]]
) -> MissingFact:
    totals = np.repeat(result.total[:, None], STEPS, axis=1)
    allowed = np.ones(totals.shape, np.bool_)
    shares = (np.arange(STEPS) + 0.5) / STEPS
    for row, criterion in cells:
        cell = matrix.cell(matrix.alternatives[row], criterion.name)
        if criterion.weight > 0:
            points = np.array([points_at(cell, criterion, result.profile, share) for share in shares.tolist()])
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
    asks = cell.unknown and shown.demand is not None and not any(criterion.weight > 0 for _, criterion in cells)
    return MissingFact(
        fact=name,
        cells=tuple((matrix.alternatives[row], criterion.name) for row, criterion in cells),
        unit="points" if cell.unknown else shown.unit,
        p_change=float((best != base).mean()),
        gain=float((totals.max(axis=0) - totals[base]).mean()) / result.ideal,
        turns=_turns(result, best, base, cell),
        rule=shown.demand.rule(shown.name, shown.unit) if asks and shown.demand is not None else "",
    )


def _meets(cell: Cell, criterion: Criterion, shares: Array) -> NDArray[np.bool_]:
    demand = criterion.demand
    if demand is None or demand.in_question:
        return np.ones(shares.size, np.bool_)
    if cell.unknown:
        return np.asarray(shares >= 0.5)
    values = np.array([value_at(cell, share) for share in shares.tolist()])
    low, high = (-np.inf if demand.low is None else demand.low), (np.inf if demand.high is None else demand.high)
    return np.asarray((values >= low) & (values <= high))


def _turns(result: KesselringResult, best: NDArray[np.int64], base: int, cell: Cell) -> tuple[Turn, ...]:
    """Return the stretches with one and the same other winner."""
    edges = [0, *(np.flatnonzero(np.diff(best)) + 1).tolist(), best.size]
    turns = []
    for start, stop in pairwise(edges):
        if best[start] == base:
            continue
        if cell.unknown:
            span = result.profile.p_max - result.profile.p_min
            low, high = (result.profile.p_min + span * edge / STEPS for edge in (start, stop))
        else:
            low, high = (value_at(cell, edge / STEPS) for edge in (start, stop))
        winner = "" if best[start] < 0 else result.alternatives[int(best[start])]
        turns.append(Turn(winner=winner, low=low, high=high))
    return tuple(turns)


def _stretch(turn: Turn, unit: str) -> str:
    if unit == YES_NO:
        return ""
    suffix = "" if unit == "1" else f" {unit}"
    return f"from {turn.low:.3g} to {turn.high:.3g}{suffix}"
