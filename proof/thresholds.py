"""Detection thresholds: gains that clean rigs exceed with a stated probability, from the tail of their gains."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from proof.null_gains import NullGain

FALSE_ALARM = 0.002  # [1] probability per mechanism: about 3 % for any of sixteen on a clean rig
FEWEST = 20  # clean rigs: with fewer, the tail is not determined
_TAIL = 0.8  # quantile above which the tail begins
_FEWEST_IN_TAIL = 4


@dataclass(frozen=True, kw_only=True)
class Threshold:
    """The threshold of one mechanism, and its data.

    Parameters
    ----------
    mechanism : str
    gain : float or None
        Smallest gain of a finding; None with too few rigs.
    tried : int
        Number of clean rigs to which it was fitted with all parameters free.
    passed : int
        Number of these on which it explained the share that a finding needs.
    median, largest : float
        Of the gains of those; 0 if there are none.
    """

    mechanism: str
    gain: float | None
    tried: int
    passed: int
    median: float
    largest: float


def thresholds(rigs: Sequence[Sequence[NullGain]], *, least_share: float) -> tuple[Threshold, ...]:
    """Return the threshold of every mechanism that was fully fitted to any clean rig, highest gain first.

    Only fits that explain ``least_share`` count, as others cannot be findings. A rig without such a fit has gain 0.
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
    """Return for each clean rig the largest gain of a possible finding; 0 if there is none."""
    return [max((one.gain for one in rig if one.share > least_share), default=0.0) for rig in rigs]


def exceeded_once(gains: Sequence[float], *, rigs: int, false_alarm: float = FALSE_ALARM) -> float:
    """Return the gain that a further clean rig exceeds with probability ``false_alarm``, at least the largest so far.

    Gains above their 80 % quantile are modelled as exponential (peaks over a threshold, Pickands 1975, Annals of
    Statistics 3(1), with shape 0). Not valid for a heavier tail.
    """
    every = np.zeros(rigs)
    every[: len(gains)] = gains
    start = float(np.quantile(every, _TAIL))
    beyond = every[every > start] - start
    if beyond.size < _FEWEST_IN_TAIL:
        return float(every.max())
    expected = beyond.size / rigs / false_alarm
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
        "chance": FALSE_ALARM,
        "thresholds": dict(sorted(stated.items())),
    }
