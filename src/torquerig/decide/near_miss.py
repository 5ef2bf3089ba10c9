"""Who was eliminated by a hair: how near each broken demand was to being met."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.eliminate import Decision, Remark, SelectionChart

NEAR = 0.1  # [1] of the limit


@dataclass(frozen=True, kw_only=True)
class NearMiss:
    """One alternative that a demand eliminated although it nearly met it.

    Parameters
    ----------
    alternative : str
    remark : Remark
        The demand with limit, value, miss, unit and source.
    share : float
        The miss as a share of the limit [1].
    """

    alternative: str
    remark: Remark
    share: float

    def sentence(self) -> str:
        """Return the near miss as one sentence."""
        return f"{self.alternative} misses by {self.share:.1%} of the limit only: {self.remark.sentence()}"


def near_misses(chart: SelectionChart, *, within: float = NEAR) -> tuple[NearMiss, ...]:
    """Return those whose eliminating value lies within this share of its limit, the nearest first.

    A demand of yes or no is not missed nearly. Because a row stops at its first ``-``, what comes after it may still
    eliminate; a limit of zero has no share of it, and is left out.
    """
    found = [
        NearMiss(alternative=row.alternative, remark=remark, share=remark.miss / abs(remark.limit))
        for row in chart.rows
        if row.decision in (Decision.ELIMINATE, Decision.REVISE)
        for remark in row.remarks
        if remark.miss is not None and remark.limit
    ]
    return tuple(sorted((one for one in found if one.share <= within), key=lambda one: (one.share, one.alternative)))
