"""Numbers of a data sheet: the value that the scenario states, its spread, and the true value of the rig."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Stated:
    """A stated number: ``value`` in ``unit``, relative standard deviation ``rel_sd`` (0: known exactly)."""

    value: float
    unit: str
    rel_sd: float = 0.0

    def written(self) -> Any:
        """Return the number as a scenario writes it."""
        shown = f"{self.value:.6g} {self.unit}" if self.unit else float(f"{self.value:.6g}")
        return {"value": shown, "rel_sd": self.rel_sd} if self.rel_sd else shown


Parts = dict[str, dict[str, Any]]


def written(node: Any) -> Any:
    """Return a tree of parts with every stated number as a scenario writes it."""
    if isinstance(node, Stated):
        return node.written()
    if isinstance(node, Mapping):
        return {key: written(value) for key, value in node.items()}
    if isinstance(node, list | tuple):
        return [written(value) for value in node]
    return node


def true_values(node: Any, rng: np.random.Generator) -> Any:
    """Return a tree of parts with one true value drawn for every stated number (log-normal around the stated one)."""
    if isinstance(node, Stated):
        factor = float(np.exp(node.rel_sd * np.clip(rng.standard_normal(), -2.5, 2.5)))
        return float(f"{node.value:.6g}") * factor
    if isinstance(node, Mapping):
        return {key: true_values(value, rng) for key, value in node.items()}
    if isinstance(node, list | tuple):
        return [true_values(value, rng) for value in node]
    return node


def true_over_stated(stated: Any, true: Any) -> dict[str, float]:
    """Return true over stated value of every number with a spread, by its path."""
    return {path: one / number.value for path, number, one in _pairs(stated, true, "") if number.rel_sd}


def _pairs(stated: Any, true: Any, path: str) -> Iterator[tuple[str, Stated, float]]:
    if isinstance(stated, Stated):
        yield path.lstrip("."), stated, true
    elif isinstance(stated, Mapping):
        for key, value in stated.items():
            yield from _pairs(value, true[key], f"{path}.{key}")
    elif isinstance(stated, list | tuple):
        for i, value in enumerate(stated):
            yield from _pairs(value, true[i], f"{path}.{i}")
