"""Which random numbers a seed draws; a seed may state the quantiles of some of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from statistics import NormalDist
from types import MappingProxyType
from typing import Any

import numpy as np

from torquerig.recordings.recording import random_for


class ChosenDraws(int):
    """A seed, and the quantiles [0..1] of the draws that are not left to it, by the name of the draw.

    ``drawn`` collects the names of all draws made with this seed that had anything to draw.
    """

    quantiles: Mapping[str, float]
    drawn: dict[str, None]

    def __new__(cls, seed: int, quantiles: Mapping[str, float] = MappingProxyType({})) -> ChosenDraws:
        """Return the seed."""
        made = super().__new__(cls, seed)
        made.quantiles, made.drawn = quantiles, {}
        return made


class WatchedDraws:
    """A generator that notes that something was drawn, at a stated quantile or at random."""

    def __init__(self, seed: ChosenDraws, name: str) -> None:
        self.seed, self.name = seed, name

    def uniform(self, low: float = 0.0, high: float = 1.0) -> float:
        """Return a number between low and high."""
        at = self._quantile()
        return float(self._random().uniform(low, high) if at is None else low + at * (high - low))

    def standard_normal(self) -> float:
        """Return a number of the standard normal distribution."""
        at = self._quantile()
        if at is None:
            return float(self._random().standard_normal())
        return NormalDist().inv_cdf(min(max(at, 1e-9), 1 - 1e-9))

    def choice(self, choices: Sequence[Any]) -> Any:
        """Return one of the choices."""
        at = self._quantile()
        return self._random().choice(choices) if at is None else choices[self._of(len(choices), at)]

    def integers(self, count: int) -> int:
        """Return a whole number from 0 to below ``count``."""
        at = self._quantile()
        return int(self._random().integers(count)) if at is None else self._of(count, at)

    def _quantile(self) -> float | None:
        self.seed.drawn[self.name] = None
        return self.seed.quantiles.get(self.name)

    def _random(self) -> np.random.Generator:
        return random_for(int(self.seed), self.name)

    @staticmethod
    def _of(count: int, at: float) -> int:
        return min(int(at * count), count - 1)


def draws_of(seed: int, name: str) -> np.random.Generator | WatchedDraws:
    """Return what draws one value: ``random_for``, but where the seed states the quantile of this draw."""
    return WatchedDraws(seed, name) if isinstance(seed, ChosenDraws) else random_for(seed, name)
