"""The shafts of a rig on which a torque may act, one for each node that moves by itself."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import GROUND

_WHOLE = 2e-3  # [1] relative, of an angle that was measured, and
_NEAR = 4e-3  # [1/rev]: so near to a whole number an order is taken for it
_HIGHEST = 400  # an order above this is near to a whole number whatever it is


@dataclass(frozen=True)
class Shaft:
    """A node: the part that it is known by, and its turns per turn of the motor."""

    part: str
    turns: float


def shafts_of(rig: Rig) -> tuple[Shaft, ...]:
    """Return the shafts that turn, in the order of the rig's parts; branches are left out."""
    turns = Twin(rig).turns
    found: dict[str, Shaft] = {}
    for part in rig.parts:
        if (part.on_shaft or part.opens_node) and not part.ends_shaft:
            node = rig.node(part.name)
            if node != GROUND and turns.get(node, 0.0) > 0:
                found.setdefault(node, Shaft(part.name, turns[node]))
    return tuple(found.values())


def whole_order(order: float, *, within: float = _WHOLE) -> int | None:
    """Return the whole number that an order is, or None; ``within`` is the relative error of found orders [1]."""
    whole = round(order)
    return whole if 0 < whole <= _HIGHEST and abs(order - whole) < max(within * order, _NEAR) else None
