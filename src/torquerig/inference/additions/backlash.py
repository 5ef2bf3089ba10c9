"""Backlash: a gap in a gear whose torque comes near zero in one of the runs."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from torquerig import mechanisms
from torquerig.errors import TorquerigError
from torquerig.inference.addition import Addition, free_name
from torquerig.inference.context import Context
from torquerig.inference.gap_width import Width, estimated_width
from torquerig.inference.prediction.gap_change import (
    ARCMIN,
    WIDTHS,
    can_be_simulated,
    comes_near_zero,
    simulated_rests,
)
from torquerig.rig.parts import Gear, WormGear

NAMES = ("backlash",)
KEEPS = True

_LOG_ODDS = -3.0
_GAP, _SPREAD = 6.0, 1.2  # [arcmin] prior median of the width, handbooks have 3 to 20; and of its logarithm


def propose(context: Context) -> Iterator[Addition]:
    """Yield a gap in each gear in which flanks would part, of the width that the rests of the torque determine.

    A gap that never opens shows nothing and is not proposed. Rests that speak against a gap count against it; those
    that speak for it only give its width, because other effects may make them too.
    """
    rig, runs = context.rig, [seen.run for seen in context.data.seen]
    if rig.of_kind("backlash") or not all(map(can_be_simulated, runs)) or not any(map(comes_near_zero, runs)):
        return
    gears: tuple[Gear | WormGear, ...] = (*rig.parts_of(Gear), *rig.parts_of(WormGear))
    for gear in gears:
        part = mechanisms.Backlash(name=free_name(rig, "backlash"), gear=gear.name, gap=_GAP * ARCMIN)
        width = None if gear.backlash else _width(context, part)
        if width is not None:
            yield Addition(
                mechanism="backlash", parts=(replace(part, gap=width.value * ARCMIN),), starts=((),),
                log_odds=_LOG_ODDS + min(width.gain, 0.0), label=f"a gap in {gear.name}",
                estimated={"gap_arcmin": (width.value, width.low, width.high, "arcmin")},
            )  # fmt: skip


def _width(context: Context, part: mechanisms.Backlash) -> Width | None:
    """Return the width [arcmin]; None where no width would show in any run, or the rig cannot be simulated."""
    try:
        found = [simulated_rests(context.rig, part, seen) for seen in context.data.seen]
    except TorquerigError:
        return None
    shown = [each for each in found if each is not None]
    return estimated_width(shown, np.array(WIDTHS), median=_GAP, spread=_SPREAD) if shown else None
