"""Imbalance: gravity on a shaft whose centre of mass is off the axis, once a turn."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size

NAMES = ("imbalance",)

_LOG_ODDS = -5.0  # of one shaft: balanced to ISO 21940-11 it is below what a sensor shows
_MASS = 1.0  # [kg] only mass times eccentricity shows


def propose(context: Context) -> Iterator[Addition]:
    """Yield a weight off the axis for each shaft that shows a line once a turn."""
    name = free_name(context.rig, "imbalance")
    for shaft in context.shafts:
        for place in context.at_orders(shaft.turns, (1.0,)).values():

            def weight(off: float, at: str = shaft.part) -> mechanisms.Imbalance:
                return mechanisms.Imbalance(name=name, at=at, mass=_MASS, eccentricity=off)

            yield from one_size(
                context, weight, field="eccentricity", place=place, mechanism="imbalance", log_odds=_LOG_ODDS,
                label=f"an imbalance of {shaft.part}, once a turn",
                reported=(Reported("unbalance_kgm", "eccentricity", "kg*m"),),
            )  # fmt: skip
