"""Near misses: alternatives that a requirement eliminated although they nearly met it."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.eliminate import Decision, Remark, SelectionChart

NEAR = 0.1  # [1] of the limit; a miss that a change of the limit by 10 % would remove


@dataclass(frozen=True, kw_only=True)
class NearMiss:
    """One alternative that a requirement eliminated although it nearly met it.

    Parameters
    ----------
    alternative : str
    remark : Remark
        The requirement with limit, value, miss, unit and source.
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
    """Return the alternatives whose eliminating value lies within this share of its limit, the nearest first.

    A requirement of yes or no has no near miss, and a limit of zero is left out. A row stops at its first ``-``: a
    later requirement may also eliminate the alternative.
    """
    found = [
        NearMiss(alternative=row.alternative, remark=remark, share=remark.miss / abs(remark.limit))
        for row in chart.rows
        if row.decision in (Decision.ELIMINATE, Decision.REVISE)
        for remark in row.remarks
        if remark.miss is not None and remark.limit
    ]
    return tuple(sorted((one for one in found if one.share <= within), key=lambda one: (one.share, one.alternative)))
