"""Which gain does an effect that is not there reach once in so many rigs? From the tail of the gains on clean ones."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from proof.null_gains import NullGain

CHANCE = 0.002  # for each mechanism: about 3 % that any of sixteen is named on a clean rig
FEWEST = 20  # clean rigs without which a tail is a guess
_TAIL = 0.8  # quantile above which the tail begins
_FEWEST_IN_TAIL = 4


@dataclass(frozen=True, kw_only=True)
class Threshold:
    """The least gain of one mechanism, and what it rests on.

    Parameters
    ----------
    mechanism : str
    gain : float or None
        None where too few rigs were run.
    tried : int
        On how many clean rigs it was fitted with all numbers free.
    passed : int
        On how many of them it explained as much of its places as a finding must.
    median, largest : float
        Of the gains of those that passed; 0 where none did.
    """

    mechanism: str
    gain: float | None
    tried: int
    passed: int
    median: float
    largest: float


def thresholds(rigs: Sequence[Sequence[NullGain]], *, least_share: float) -> tuple[Threshold, ...]:
    """Return the threshold of every mechanism that came to a full fit on any clean rig, highest gain first.

    Only fits that explain ``least_share`` of their places count, as nothing else could be named; a rig without such a
    fit counts as one whose gain is 0.
    """
    tried: dict[str, list[NullGain]] = {}
    for rig in rigs:
        for one in rig:
            tried.setdefault(one.mechanism, []).append(one)
    found = []
    for name, fits in tried.items():
        passed = [one.gain for one in fits if one.share > least_share and one.gain > 0.0]
        gain = exceeded_once(passed, rigs=len(rigs)) if len(rigs) >= FEWEST else None
        found.append(
            Threshold(
                mechanism=name, gain=gain, tried=len(fits), passed=len(passed),
                median=float(np.median(passed)) if passed else 0.0, largest=max(passed, default=0.0),
            )
        )  # fmt: skip
    return tuple(sorted(found, key=lambda one: -one.largest))


def best_gains(rigs: Sequence[Sequence[NullGain]], *, least_share: float) -> list[float]:
    """Return for each clean rig the gain of the best effect that could have been named; 0 where none could."""
    return [max((one.gain for one in rig if one.share > least_share), default=0.0) for rig in rigs]


def exceeded_once(gains: Sequence[float], *, rigs: int, chance: float = CHANCE) -> float:
    """Return the gain that a further clean rig exceeds with ``chance``, at least the largest that was seen.

    Gains above their 80 % quantile are taken for exponential (peaks over a threshold, Pickands 1975, Annals of
    Statistics 3(1), with shape 0). Untrue where the tail is heavier than that; more rigs show it.
    """
    every = np.zeros(rigs)
    every[: len(gains)] = gains
    start = float(np.quantile(every, _TAIL))
    beyond = every[every > start] - start
    if beyond.size < _FEWEST_IN_TAIL:
        return float(every.max())
    expected = beyond.size / rigs / chance
    return max(float(every.max()), start + float(beyond.mean()) * float(np.log(max(expected, 1.0))))


def as_table(
    found: Sequence[Threshold], *, key: str, title: str, command: str, seeds: Sequence[int], clean_rigs: int
) -> dict[str, Any]:
    """Return one entry of ``null_tables.yaml``."""
    stated: Mapping[str, float] = {
        one.mechanism: float(f"{one.gain:.4g}") for one in found if one.gain is not None and one.gain > 0.0
    }
    return {
        "scenario": key,
        "title": title,
        "made_by": command,
        "seeds": list(seeds),
        "clean_rigs": clean_rigs,
        "chance": CHANCE,
        "thresholds": dict(sorted(stated.items())),
    }
