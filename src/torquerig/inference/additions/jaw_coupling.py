"""Jaw coupling: unequal jaws and legs of its spider, once a jaw and once a leg."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.linear_twin.twin import Twin
from torquerig.rig.parts import Coupling

NAMES = ("jaw_coupling",)

_LOG_ODDS = -7.0  # of one coupling and one number of jaws
_JAWS = range(3, 9)  # with two, an offset has the same lines (parallel_offset)
_FIELDS = {1: "jaw_error", 2: "leg_error"}


def propose(context: Context) -> Iterator[Addition]:
    """Yield unequal jaws of each coupling for each number of jaws that a found line is at."""
    turns = Twin(context.rig).turns
    for coupling in context.rig.parts_of(Coupling):
        own = turns.get(context.rig.node(coupling.name), 0.0)
        for jaws in _JAWS if own else ():
            lines = context.at_orders(own, (float(jaws), 2.0 * jaws))
            if jaws in lines:
                yield from _uneven(context, coupling.name, jaws, {round(k / jaws): at for k, at in lines.items()})


def _uneven(context: Context, coupling: str, jaws: int, lines: dict[int, Place]) -> Iterator[Addition]:
    name = free_name(context.rig, "jaw_coupling")

    def uneven(sizes: dict[int, float]) -> mechanisms.JawCoupling:
        return mechanisms.JawCoupling(
            name=name, coupling=coupling, jaws=jaws, jaw_error=sizes.get(1, 0.0), leg_error=sizes.get(2, 0.0)
        )

    found = harmonics(
        context, lines, unit=lambda multiple: uneven({multiple: 1.0}),
        knob=lambda multiple: Knob(name, _FIELDS[multiple], DECADE),
    )  # fmt: skip
    if 1 in found.medians:
        yield Addition(
            mechanism="jaw_coupling", parts=(uneven(found.medians),), knobs=tuple(found.knobs),
            starts=(tuple(found.start),), places=tuple(lines.values()), log_odds=_LOG_ODDS,
            label=f"unequal jaws of {coupling}", fixed={"jaws": (float(jaws), 0.0, "1")},
            reported=(Reported("jaw_error_rad", "jaw_error", "rad"),),
        )  # fmt: skip
