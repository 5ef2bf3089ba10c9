"""The answer of a matrix in one word, and what that word rests on: robust, fragile, tie, or undecidable."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from torquerig.decide.eliminate import Decision, SelectionChart
from torquerig.decide.kesselring import KesselringResult
from torquerig.decide.ranks import TIE
from torquerig.decide.robustness import Acceptability

ROBUST = 0.9  # [1] how often the winner must be best for the word robust
DECIDED = 2 / 3  # [1] how often over the open facts alone, below which these decide and not the matrix


class Word(StrEnum):
    """How sure the winner is."""

    ROBUST = "robust"
    FRAGILE = "fragile"
    TIE = "tie"
    UNDECIDABLE = "undecidable for lack of information"
    NOBODY = "nobody meets the demands"


@dataclass(frozen=True, kw_only=True)
class MatrixVerdict:
    """Who wins, and how sure that is.

    Parameters
    ----------
    word : Word
    winners : tuple of str
        In front by T; several where they tie, none where nobody meets the demands.
    runner_up : str
    lead : float
        T/T_max of the winner above the runner-up [1].
    chances : mapping of str to float
        How often the winner is best by what is drawn: ``intervals``, ``scores``, ``weights``, ``together``.
    words : mapping of str to Word
        Robust or fragile against each of these alone.
    conditions : tuple of str
        What must still turn out well for the winner to meet the demands.
    """

    word: Word
    winners: tuple[str, ...]
    runner_up: str
    lead: float
    chances: Mapping[str, float]
    words: Mapping[str, Word]
    conditions: tuple[str, ...]

    def sentence(self) -> str:
        """Return the verdict for the reader."""
        if not self.winners:
            return "Nobody meets the demands: see by how much each one misses."
        told = f"{' and '.join(self.winners)} {'is' if len(self.winners) == 1 else 'are'} in front"
        told += f", {self.lead:.3f} in T/T_max before {self.runner_up}" if self.runner_up else ", and alone"
        parts = ", ".join(f"{chance:.0%} over {name}" for name, chance in self.chances.items() if name != "together")
        sure = f"best in {self.chances['together']:.0%} of joint draws ({parts})" if self.runner_up else ""
        still = f" Still open: {'; '.join(self.conditions)}." if self.conditions else ""
        return f"{told}. The verdict is {self.word}{f': {sure}' if sure else ''}.{still}"


def verdict_of(
    chart: SelectionChart, result: KesselringResult | None, found: Mapping[str, Acceptability]
) -> MatrixVerdict:
    """Return the verdict of the three methods.

    Undecidable: a demand on the winner is still open, or over the open facts alone it is best in fewer than two of
    three draws. Tie: nothing is open that could tell the first two apart and their T is the same. Robust: best in at
    least nine of ten joint draws of facts, points and weights. Fragile: all else.

    Parameters
    ----------
    result : KesselringResult or None
        Of those that no demand eliminated; None where nobody is left.
    found : mapping of str to Acceptability
        As :func:`torquerig.decide.robustness.robustness` gives it for the same alternatives.
    """
    if result is None:
        return MatrixVerdict(
            word=Word.NOBODY, winners=(), runner_up="", lead=0.0, chances={}, words={}, conditions=()
        )  # fmt: skip
    order = np.argsort(-result.total, kind="stable").tolist()
    top = float(result.total[order[0]])
    winners = tuple(result.alternatives[row] for row in order if result.total[row] >= top - TIE)
    rest = [row for row in order if result.total[row] < top - TIE]
    chances = {name: one.chance(winners[0]) for name, one in found.items()}
    conditions = tuple(
        f"{row.alternative}: {remark.missing}"
        for row in chart.rows
        if row.alternative in winners
        for remark in row.remarks
        if remark.missing
    )
    return MatrixVerdict(
        word=_word(chart, winners, chances),
        winners=winners,
        runner_up=result.alternatives[rest[0]] if rest else "",
        lead=float(top - result.total[rest[0]]) / result.ideal if rest else 0.0,
        chances=chances,
        words={name: Word.ROBUST if chance >= ROBUST else Word.FRAGILE for name, chance in chances.items()},
        conditions=conditions,
    )


def _word(chart: SelectionChart, winners: tuple[str, ...], chances: Mapping[str, float]) -> Word:
    pursued = set(chart.with_decision(Decision.PURSUE))
    tied = len(winners) > 1
    # a tie of known values is shared equally, so its winner is best in 1 of so many draws
    open_facts = chances["intervals"] < DECIDED and not (tied and abs(chances["intervals"] - 1 / len(winners)) < TIE)
    if open_facts or not set(winners) <= pursued:
        return Word.UNDECIDABLE
    if tied:
        return Word.TIE
    return Word.ROBUST if chances["together"] >= ROBUST else Word.FRAGILE
