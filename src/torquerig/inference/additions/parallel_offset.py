"""Parallel offset: parallel shafts with an offset in a coupling of two jaws, once and twice a turn."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name, start_of
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.linear_twin.twin import Twin
from torquerig.rig.parts import Coupling

NAMES = ("parallel_offset",)

_LOG_ODDS = -5.5  # of one coupling
_RADIUS = 1.0  # [m] only the offset over the radius of the jaws shows
_SMALL = 0.02  # [1] of the radius: twice a turn the error grows by its square
_UNEQUAL, _UNEQUAL_SPREAD = 0.2, 1.0  # what one jaw carries more than the other, and of its logarithm


def propose(context: Context) -> Iterator[Addition]:
    """Yield an offset in each coupling that shows lines once and twice a turn."""
    turns = Twin(context.rig).turns
    for coupling in context.rig.parts_of(Coupling):
        own = turns.get(context.rig.node(coupling.name), 0.0)
        lines = context.at_orders(own, (1.0, 2.0)) if own else {}
        if {1.0, 2.0} <= lines.keys():
            yield from _offset(context, coupling.name, lines)


def _offset(context: Context, coupling: str, lines: dict[float, Place]) -> Iterator[Addition]:
    name = free_name(context.rig, "parallel_offset")

    def shifted(offset: float, unequal: float) -> mechanisms.ParallelOffset:
        return mechanisms.ParallelOffset(
            name=name, coupling=coupling, offset=offset, radius=_RADIUS, unequal_share=unequal
        )

    twice, median = context.size_of(shifted(_SMALL, _UNEQUAL), lines[2.0])
    if not median:
        return
    value, middle = _SMALL * twice**0.5, _SMALL * median**0.5
    once, _ = context.size_of(shifted(value, _UNEQUAL), lines[1.0])
    yield Addition(
        mechanism="parallel_offset", parts=(shifted(middle, _UNEQUAL),), places=tuple(lines.values()),
        knobs=(Knob(name, "offset", 0.5 * DECADE), Knob(name, "unequal_share", _UNEQUAL_SPREAD)),
        starts=((start_of(value, middle, 0.5 * DECADE), start_of(once, 1.0, _UNEQUAL_SPREAD)),), log_odds=_LOG_ODDS,
        label=f"an offset of the shafts at {coupling}",
        reported=(Reported("offset_over_radius", "offset", "1"), Reported("unequal_share", "unequal_share", "1")),
    )  # fmt: skip
