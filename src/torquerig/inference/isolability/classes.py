"""Hypotheses with parallel signatures: these recordings cannot tell them apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from torquerig.inference.isolability.signatures import Signature

ALIKE = float(np.log(20.0))  # [nats] below which a hypothesis is not excluded (5 % against 95 %)
_LARGER = 2.0  # times the smallest visible size, for which two hypotheses are compared


@dataclass(frozen=True, eq=False)
class Pair:
    """Two hypotheses and the log-likelihood [nats] by which the runs separate them at twice their smallest size."""

    one: Signature
    other: Signature
    nats: float


def separation(one: Signature, other: Signature) -> float:
    """Return the log-likelihood [nats] that the first hypothesis keeps over the second, whatever the second's size.

    ``1/2 |d|^2 (1 - cos^2)`` with the angle between the changes; both grow with their size along their direction.
    """
    square = float(one.change @ one.change)
    cosine = float(one.change @ other.change) / np.sqrt(square * float(other.change @ other.change))
    opposed = cosine < 0 and not (one.two_sided or other.two_sided)
    return np.inf if opposed else 0.5 * square * (1 - cosine**2) * _LARGER**2


def inseparable(found: Sequence[Signature]) -> list[Pair]:
    """Return pairs of different mechanisms that the runs do not separate, the closest first, one for each two names."""
    closest: dict[tuple[str, ...], Pair] = {}
    for row, one in enumerate(found):
        for other in found[row + 1 :]:
            names = tuple(sorted((one.addition.mechanism, other.addition.mechanism)))
            nats = separation(one, other)
            if names[0] != names[1] and nats < ALIKE and nats < getattr(closest.get(names), "nats", np.inf):
                closest[names] = Pair(one, other, nats)
    return sorted(closest.values(), key=lambda pair: pair.nats)
