"""Cases of a set of blind trials: kinds in fixed shares, in random order, each drawn from seed and number."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import cycle, islice
from typing import TypeVar

import numpy as np

from proof.rig_program.draw import Case, draw_case
from proof.rig_program.effect_draws import IN_LIBRARY, IN_NO_LIBRARY

_T = TypeVar("_T")

# 45 % of the cases have no effect of the library
SHARES = {"clean": 0.20, "wrong_parameters": 0.10, "outside": 0.12, "outside_and_one": 0.03, "two": 0.12, "one": 0.43}


@dataclass(frozen=True)
class CaseKind:
    """Kind of a case: effects, a second effect, or parameters far from nominal."""

    effects: tuple[str, ...] = ()
    second: bool = False
    wrong_parameters: bool = False


def case_kinds(seed: int, cases: int) -> list[CaseKind]:
    """Return the kinds of the cases; all effects have the same number of cases, within one."""
    rng = np.random.default_rng([seed, 0])
    counts = {kind: int(np.floor(share * cases)) for kind, share in SHARES.items()}
    # remainders go to the cases without effects first, so that these are at least 40 %
    for kind in islice(cycle(("clean", "outside", "one", "wrong_parameters", "two")), cases - sum(counts.values())):
        counts[kind] += 1
    inside, outside = (cycle(_shuffled(rng, list(kinds))) for kinds in (IN_LIBRARY, IN_NO_LIBRARY))
    drawn = [CaseKind()] * counts["clean"] + [CaseKind(wrong_parameters=True)] * counts["wrong_parameters"]
    drawn += [CaseKind((next(outside),)) for _ in range(counts["outside"])]
    drawn += [CaseKind((next(outside),), second=True) for _ in range(counts["outside_and_one"])]
    drawn += [CaseKind((next(inside),)) for _ in range(counts["one"])]
    drawn += [CaseKind((next(inside),), second=True) for _ in range(counts["two"])]
    return _shuffled(rng, drawn)


def draw_trials(seed: int, cases: int, *, same_laws: bool = False, duration: float = 12.0) -> list[Case]:
    """Return the cases of a seed; the same seed and number give the same cases."""
    numbers = range(1, cases + 1)
    return [draw_trial(seed, number, cases, same_laws=same_laws, duration=duration) for number in numbers]


def draw_trial(seed: int, number: int, cases: int, *, same_laws: bool = False, duration: float = 12.0) -> Case:
    """Return one of the cases of a seed, ``number`` 1 to ``cases``."""
    kind = case_kinds(seed, cases)[number - 1]
    return draw_case(
        f"case-{number:03d}",
        (seed, number),
        kind.effects,
        wrong_parameters=kind.wrong_parameters,
        same_laws=same_laws,
        second=kind.second,
        duration=duration,
    )


def _shuffled(rng: np.random.Generator, items: Sequence[_T]) -> list[_T]:
    """Return a shuffled copy."""
    return [items[int(i)] for i in rng.permutation(len(items))]
