"""Rigs with hidden effects: the first of a wanted mechanism, further ones at random, each with how well it shows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from proof.fleet.counting import Shown, shown
from proof.fleet.effect import Effect
from proof.fleet.effects import MECHANISMS
from proof.fleet.rig import FleetRig, draw_rig
from proof.fleet.setting import Setting, setting_of

SHARES = {0: 0.10, 1: 0.45, 2: 0.25, 3: 0.12, 4: 0.08}
"""Share of the rigs by their number of effects."""
RIGS, SIZES = 60, 5  # tries of a rig that can have a mechanism, and of a size that counts


class NoRigError(RuntimeError):
    """No drawn rig can have the wanted effect."""


@dataclass(frozen=True)
class FleetCase:
    """A rig with effects and how well each of them shows."""

    rig: FleetRig
    shown: tuple[Shown, ...] = ()


def draw_case(name: str, seed: tuple[int, ...], kinds: Sequence[str]) -> FleetCase:
    """Draw a rig with effects of these kinds; the rig is one that can have the first, others are left out if it can't.

    A size that does not count is drawn again, a few times; the last is kept, and is not counted.
    """
    rng = np.random.default_rng([*seed, 21])
    for attempt in range(RIGS):
        rig = draw_rig(name, (*seed, attempt))
        if not kinds:
            return FleetCase(rig)
        setting = setting_of(rig)
        if MECHANISMS[kinds[0]](np.random.default_rng(0), setting) is None:
            continue
        return with_effects(rig, setting, [MECHANISMS[kind] for kind in kinds], rng)
    raise NoRigError(f"{name}: none of {RIGS} drawn rigs can have {kinds[0]}")


def with_effects(rig: FleetRig, setting: Setting, draws: Sequence[Any], rng: np.random.Generator) -> FleetCase:
    """Return the rig with one effect of each draw, as far as it can have them."""
    kept: list[Effect] = []
    last = None
    for draw in draws:
        for _ in range(SIZES):
            effect = draw(rng, setting)
            if effect is None:
                break
            last = shown(replace(rig, effects=(*kept, effect)), effect)
            if last.counts:
                break
        if effect is not None:
            kept.append(effect)
    whole = replace(rig, effects=tuple(kept))
    # earlier effects are judged again next to the later ones
    earlier = [shown(whole, effect) for effect in kept[:-1]]
    return FleetCase(whole, (*earlier, last) if kept and last is not None else ())


def draw_kinds(number: int, rng: np.random.Generator) -> tuple[str, ...]:
    """Return the mechanisms of case ``number``: the first in turn, so that every mechanism occurs, others at random."""
    count = int(rng.choice(list(SHARES), p=list(SHARES.values())))
    names = list(MECHANISMS)
    if count == 0:
        return ()
    first = names[number % len(names)]
    others = [name for name in names if name != first]
    return (first, *(str(one) for one in rng.choice(others, size=count - 1, replace=False)))
