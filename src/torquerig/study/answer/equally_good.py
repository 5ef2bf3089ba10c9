"""The best drives among some combinations of a study, and whether the data makes one of them clearly best."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.decide.verdict import DECIDED
from torquerig.study.drawn_motors import share_by_motor
from torquerig.study.rated_drives import rated_drives

if TYPE_CHECKING:
    from torquerig.decide.best_shares import SampledTotals
    from torquerig.decide.value_of_information import MissingFact
    from torquerig.study.scoring import Decided

RARE = 0.05  # [1] share of the samples below which a motor is not named as one of the best


@dataclass(frozen=True, kw_only=True)
class BestMotors:
    """The motors that are best in the samples of what the data leaves open, each with its best combination.

    Parameters
    ----------
    combinations : tuple of str
        One per motor, the motor with the largest share first.
    is_clear : bool
        Whether the first is best in at least two of three samples.
    error_low, error_high : float
        Range of the reading errors of these combinations, over their samples [unit of the effort].
    facts : tuple of MissingFact
        Missing values that alone can change which one is best, the most useful first.
    """

    combinations: tuple[str, ...]
    is_clear: bool
    error_low: float
    error_high: float
    facts: tuple[MissingFact, ...]


def best_motors(decided: Decided, names: Iterable[str], samples: SampledTotals | None = None) -> BestMotors | None:
    """Return the motors that are best among these combinations; None where there is none."""
    listed = tuple(names)
    if not listed:
        return None
    rated = rated_drives(decided, listed, samples)
    data = rated.combinations["intervals"]
    shares = share_by_motor(decided, dict(zip(data.alternatives, data.p_best.tolist(), strict=True)))
    kept = [motor for motor, share in shares.items() if share >= RARE] or [next(iter(shares))]
    is_clear = next(iter(shares.values())) >= DECIDED
    best = {decided.alternatives[name].drive.candidate.motor: name for name in reversed(listed)}
    combinations = tuple(best[motor] for motor in (kept[:1] if is_clear else kept))
    ends = [end for name in combinations for end in error_ends(decided, name)]
    return BestMotors(
        combinations=combinations, is_clear=is_clear, error_low=min(ends), error_high=max(ends),
        facts=tuple(fact for fact in rated.facts if fact.decisive),
    )  # fmt: skip


def error_ends(decided: Decided, name: str) -> tuple[float, float]:
    """Return the lowest and highest reading error of a combination over its samples [unit of the effort]."""
    made = decided.alternatives[name]
    error = made.drive.chains[made.chain].truth_error
    value = error.value or 0.0
    return (value if error.low is None else error.low), (value if error.high is None else error.high)
