"""Motors whose lines no data sheet states: a ranking among them is one of draws from their class."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from torquerig.decide.verdict import DECIDED
from torquerig.study.rated_drives import rated_drives

if TYPE_CHECKING:
    from torquerig.decide.best_shares import SampledTotals
    from torquerig.study.results import DriveResult
    from torquerig.study.scoring import Decided

MOST_NAMED = 4  # motors in a sentence


def is_drawn(drive: DriveResult) -> bool:
    """Return whether cogging or ripple of the drive's motor, or the phases they come from, are drawn from its class."""
    motor = drive.candidate.parts.motor
    drawn = tuple(f"{motor}.{field}." for field in ("ripple", "phases", "commutation"))
    return any(key.startswith(drawn) for key in drive.assumed)


def ranking_of_draws(decided: Decided) -> str:
    """Return what the ranking is among motors whose lines are drawn; empty where at most one of them is ranked."""
    ranked = {made.drive.candidate.motor: is_drawn(made.drive) for made in decided.alternatives.values()}
    drawn = [motor for motor, is_one in ranked.items() if is_one]
    if len(drawn) < 2:
        return ""
    return (
        f"Of the {len(ranked)} ranked motors, {len(drawn)} have no data sheet with their cogging and ripple: their "
        "order among each other is one of draws from the intervals of their class. "
    )


def best_new_motor_text(decided: Decided, names: Iterable[str], samples: SampledTotals | None = None) -> str:
    """Return the best motor among these combinations, all with another motor than the present one.

    It is named as best only where it is so in at least ``DECIDED`` of the samples of the data alone; else the motors
    that share the samples are listed.
    """
    listed = tuple(names)
    if not listed:
        return ""
    rated = rated_drives(decided, listed, samples)
    shares = share_by_motor(decided, dict(zip(rated.combinations["intervals"].alternatives,
                                         rated.combinations["intervals"].p_best.tolist(), strict=True)))  # fmt: skip
    first, share = next(iter(shares.items()))
    best = next(name for name in listed if decided.alternatives[name].drive.candidate.motor == first)
    if share >= DECIDED:
        return f" The best new motor is {best.replace(' | ', ' with ')}, in {share:.0%} of the samples of the data."
    named = [f"{motor} ({part:.0%})" for motor, part in shares.items() if part >= 0.05][:MOST_NAMED]
    return (
        f" No new motor is clearly best: the samples of the data have {', '.join(named)} first. Ask for the missing "
        "data before buying one."
    )


def share_by_motor(decided: Decided, shares: Mapping[str, float]) -> dict[str, float]:
    """Return the share of samples in which each motor is first, the largest first."""
    found: dict[str, float] = {}
    for name, share in shares.items():
        motor = decided.alternatives[name].drive.candidate.motor
        found[motor] = found.get(motor, 0.0) + share
    return dict(sorted(found.items(), key=lambda item: -item[1]))
