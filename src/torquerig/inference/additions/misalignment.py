"""Misalignment: shafts that meet at an angle in a coupling, twice a turn."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.linear_twin.twin import Twin
from torquerig.rig.parts import Coupling

NAMES = ("misalignment",)

_LOG_ODDS = -5.5  # of one coupling: half of them are of kinds that turn evenly at any angle
_SMALL = 0.02  # [rad] the error grows by the square of the angle


def propose(context: Context) -> Iterator[Addition]:
    """Yield an angle in each coupling that turns at half the order of a found line."""
    turns, name = Twin(context.rig).turns, free_name(context.rig, "misalignment")
    for coupling in context.rig.parts_of(Coupling):
        own = turns.get(context.rig.node(coupling.name), 0.0)
        for place in context.at_orders(own, (2.0,)).values() if own else ():

            def bent(angle: float, at: str = coupling.name) -> mechanisms.Misalignment:
                return mechanisms.Misalignment(name=name, coupling=at, angle=angle)

            yield from one_size(
                context, bent, field="angle", place=place, unit=_SMALL, power=2.0, mechanism="misalignment",
                log_odds=_LOG_ODDS, label=f"an angle between the shafts at {coupling.name}, twice a turn",
                reported=(Reported("angle_rad", "angle", "rad"),),
            )  # fmt: skip
