"""Reduction of the held-out residual, compared with the oracle."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

from proof.scoring.claims import Claim


@dataclass(frozen=True)
class Improvement:
    """Share of the held-out residual that a claim removes; ``of_oracle`` is relative to the fitted true mechanisms."""

    share: float
    of_oracle: float | None
    harmed: bool


def improvement_of(claim: Claim, oracle: Claim | None) -> Improvement | None:
    """Return the improvement of a claim with both residuals; ``harmed`` means more than 1 % worse than before.

    The oracle's share uses the residuals of the oracle's diagnosis of the same recordings.
    """
    share = _share(claim)
    if share is None or claim.before is None or claim.after is None:
        return None
    best = None if oracle is None else _share(oracle)
    return Improvement(
        share=share,
        of_oracle=None if best is None or best <= 0.0 else share / best,
        harmed=claim.after > 1.01 * claim.before,
    )


def _share(claim: Claim) -> float | None:
    """Return one minus after over before, or None."""
    if claim.before is None or claim.after is None or claim.before <= 0.0:
        return None
    share = 1.0 - claim.after / claim.before
    return share if isfinite(share) else None
