"""Verdict of a matrix: robust, fragile, tie, or open because the answer depends on missing facts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

import numpy as np

from torquerig.decide.eliminate import Decision, SelectionChart
from torquerig.decide.ranks import TIE

if TYPE_CHECKING:
    from torquerig.decide.kesselring import KesselringResult
    from torquerig.decide.robustness import RankAcceptability

ROBUST = 0.9  # [1] share of samples in which the winner must be best for the verdict "robust"
DECIDED = 2 / 3  # [1] the same share over the open facts alone, below which the answer depends on them
MOST_NAMED = 3  # facts that the sentence names; the matrix lists all of them under "What to ask next"


class Certainty(StrEnum):
    """How certain the winner is."""

    ROBUST = "robust"
    FRAGILE = "fragile"
    TIE = "tie"
    OPEN = "open: answer depends on missing facts"
    NOBODY = "no alternative meets the requirements"


@dataclass(frozen=True, kw_only=True)
class MatrixVerdict:
    """The winner, and how certain it is.

    Parameters
    ----------
    certainty : Certainty
    winners : tuple of str
        The alternatives with the highest T; several where they tie, none where no alternative meets the requirements.
    runner_up : str
    lead : float
        T/T_max of the winner minus that of the runner-up [1].
    best_shares : mapping of str to float
        The share of Monte Carlo samples in which the winner is best [1], by what is sampled: ``intervals``, ``scores``,
        ``weights``, ``together``.
    certainty_of : mapping of str to Certainty
        Robust or fragile against each of these alone.
    conditions : tuple of str
        Open requirements on the winner.
    facts : tuple of str
        Missing facts, each of which alone can change the winner.
    certainty_if_met : Certainty
        Certainty under the assumption that the open requirements on the winner are met.
    """

    certainty: Certainty
    winners: tuple[str, ...]
    runner_up: str
    lead: float
    best_shares: Mapping[str, float]
    certainty_of: Mapping[str, Certainty]
    conditions: tuple[str, ...]
    facts: tuple[str, ...] = ()
    certainty_if_met: Certainty = Certainty.NOBODY

    def certainty_text(self) -> str:
        """Return the certainty in words; where it is open, with the facts that the answer depends on."""
        named = [*self.conditions, *(fact for fact in self.facts if not any(fact in one for one in self.conditions))]
        if self.certainty is not Certainty.OPEN or not named:
            return str(self.certainty)
        more = f"; and {len(named) - MOST_NAMED} more" if len(named) > MOST_NAMED else ""
        return f"open: answer depends on {'; '.join(named[:MOST_NAMED])}{more}"

    def sentence(self) -> str:
        """Return the verdict in sentences."""
        if not self.winners:
            return "No alternative meets the requirements. The elimination shows by how much each one misses."
        one = len(self.winners) == 1
        names = " and ".join(self.winners)
        first = f"{names} {'ranks' if one else 'rank'} first"
        first += (
            f", {self.lead:.3f} in T/T_max ahead of {self.runner_up}" if self.runner_up else "; there is no other one"
        )
        text = f"{first}. The verdict is {self.certainty_text()}."
        if not self.runner_up:
            return text
        parts = ", ".join(f"{share:.0%} over {name}" for name, share in self.best_shares.items() if name != "together")
        share = f"{self.best_shares['together']:.0%} of the Monte Carlo samples ({parts})"
        return f"{text} {self.winners[0]} is best in {share}."


def verdict_of(
    chart: SelectionChart,
    result: KesselringResult | None,
    found: Mapping[str, RankAcceptability],
    *,
    facts: tuple[str, ...] = (),
) -> MatrixVerdict:
    """Return the verdict of the three methods.

    Open: a requirement on the winner is open, or over the open facts alone it is best in fewer than two of three
    samples. Tie: the first two have the same T, and no open fact can change that. Robust: best in at least nine of ten
    Monte Carlo samples of facts, points and weights. Fragile: all else.

    Parameters
    ----------
    result : KesselringResult or None
        Of the alternatives that no requirement eliminates; None where there is none.
    found : mapping of str to RankAcceptability
        As :func:`torquerig.decide.robustness.robustness` gives it for the same alternatives.
    facts : tuple of str
        Missing facts, each of which alone can change the winner.
    """
    if result is None:
        return MatrixVerdict(
            certainty=Certainty.NOBODY, winners=(), runner_up="", lead=0.0, best_shares={}, certainty_of={},
            conditions=(),
        )  # fmt: skip
    order = np.argsort(-result.total, kind="stable").tolist()
    top = float(result.total[order[0]])
    winners = tuple(result.alternatives[row] for row in order if result.total[row] >= top - TIE)
    rest = [row for row in order if result.total[row] < top - TIE]
    best_shares = {name: one.best_share(winners[0]) for name, one in found.items()}
    conditions = tuple(
        f"{row.alternative}: {remark.missing}"
        for row in chart.rows
        if row.alternative in winners
        for remark in row.remarks
        if remark.missing
    )
    pursued = set(winners) <= set(chart.with_decision(Decision.PURSUE))
    if_met = _certainty(winners, best_shares)
    return MatrixVerdict(
        certainty=if_met if pursued else Certainty.OPEN,
        certainty_if_met=if_met,
        winners=winners,
        runner_up=result.alternatives[rest[0]] if rest else "",
        lead=float(top - result.total[rest[0]]) / result.ideal if rest else 0.0,
        best_shares=best_shares,
        certainty_of={
            name: Certainty.ROBUST if best_share >= ROBUST else Certainty.FRAGILE
            for name, best_share in best_shares.items()
        },
        conditions=conditions,
        facts=facts,
    )


def _certainty(winners: tuple[str, ...], best_shares: Mapping[str, float]) -> Certainty:
    """Return the certainty, the requirements on the winners taken as met."""
    tied = len(winners) > 1
    # a tie of known values is shared equally, so its winner is best in 1 of so many draws
    open_facts = best_shares["intervals"] < DECIDED and not (
        tied and abs(best_shares["intervals"] - 1 / len(winners)) < TIE
    )
    if open_facts:
        return Certainty.OPEN
    if tied:
        return Certainty.TIE
    return Certainty.ROBUST if best_shares["together"] >= ROBUST else Certainty.FRAGILE
