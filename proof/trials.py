"""Which cases does a set of blind trials hold? Kinds in fixed shares, shuffled, each drawn from seed and place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import cycle, islice
from typing import TypeVar

import numpy as np

from proof.rig_program.draw import Case, draw_case
from proof.rig_program.effect_draws import IN_LIBRARY, IN_NO_LIBRARY

_T = TypeVar("_T")

# 45 in 100 cases have nothing that a library could name
SHARES = {"clean": 0.20, "wrong_parameters": 0.10, "outside": 0.12, "outside_and_one": 0.03, "two": 0.12, "one": 0.43}


@dataclass(frozen=True)
class Card:
    """What one case is to be: kinds of effects, one more besides, or parameters far from nominal."""

    kinds: tuple[str, ...] = ()
    second: bool = False
    wrong_parameters: bool = False


def deal(seed: int, cases: int) -> list[Card]:
    """Deal the cards of so many cases; every kind comes up as often as any other, give or take one."""
    rng = np.random.default_rng([seed, 0])
    counts = {kind: int(np.floor(share * cases)) for kind, share in SHARES.items()}
    # what rounding leaves goes to the blanks first, so that they are never fewer than four in ten
    for kind in islice(cycle(("clean", "outside", "one", "wrong_parameters", "two")), cases - sum(counts.values())):
        counts[kind] += 1
    inside, outside = (cycle(_shuffled(rng, list(kinds))) for kinds in (IN_LIBRARY, IN_NO_LIBRARY))
    cards = [Card()] * counts["clean"] + [Card(wrong_parameters=True)] * counts["wrong_parameters"]
    cards += [Card((next(outside),)) for _ in range(counts["outside"])]
    cards += [Card((next(outside),), second=True) for _ in range(counts["outside_and_one"])]
    cards += [Card((next(inside),)) for _ in range(counts["one"])]
    cards += [Card((next(inside),), second=True) for _ in range(counts["two"])]
    return _shuffled(rng, cards)


def draw_trials(seed: int, cases: int, *, same_laws: bool = False, duration: float = 12.0) -> list[Case]:
    """Draw so many cases; the same seed and number give the same cases."""
    return [
        draw_case(
            f"case-{i:03d}",
            (seed, i),
            card.kinds,
            wrong_parameters=card.wrong_parameters,
            same_laws=same_laws,
            second=card.second,
            duration=duration,
        )
        for i, card in enumerate(deal(seed, cases), start=1)
    ]


def _shuffled(rng: np.random.Generator, items: Sequence[_T]) -> list[_T]:
    """Shuffle without touching what was given."""
    return [items[int(i)] for i in rng.permutation(len(items))]
