"""A nameless line and its multiples: a torque of constant amplitude on one of the shafts, whatever its cause.

Or one line that swells: its amplitude changes with a period that is longer than a turn of any shaft. At one speed
it shows as lines at equal distances on both sides of its order (amplitude modulation). Each of them alone looks like a
tone of any cause; together they are one line.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, free_name
from torquerig.inference.additions.line_products import torques
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import SAME_ORDER, Place
from torquerig.inference.shafts import Shaft

_WHOLE, _ANY = (
    -6.0,
    -9.0,
)  # log-odds of a line at a whole order, and anywhere on the grid, on all shafts together
_HARMONICS = 6
_CLEAREST = 8  # lines; others follow when these are explained
_SWELLS = -12.0  # of an order anywhere on the grid, as a line_family has it, and of a period
_FEWEST = 2  # pairs of side lines: one pair may be chance
_MOST_PAIRS = 8
_WIDEST = 0.05  # [1] of the order: farther away a side line is a line of another cause
_APART = 3  # times the distance at which two orders are one: nearer side lines are in place by chance
_SLOWER = 0.5  # [1] of the slowest shaft: once a turn, and once in two, a shaft makes side lines itself
_MIDDLES = 3  # lines that may be the middle


def propose(context: Context) -> Iterator[Addition]:
    """Yield a family for each found order and each shaft on which its torque may act."""
    for line in context.lines[:_CLEAREST]:
        for shaft in context.shafts if line.place.domain == "order" else ():
            yield from _family(context, shaft, line.place)
    yield from _swelling(context)


def _family(context: Context, shaft: Shaft, place: Place) -> Iterator[Addition]:
    whole, name = context.whole(place, shaft.turns), free_name(context.rig, "unnamed_line")
    first = float(whole) if whole else place.at / shaft.turns
    multiples = context.multiples(place, most=_HARMONICS)

    def ripple(amplitudes: dict[float, float]) -> mechanisms.TorqueRipple:
        return mechanisms.TorqueRipple(name=name, at=shaft.part, group="mechanical", amplitudes=amplitudes)

    found = harmonics(
        context, multiples, unit=lambda multiple: ripple({multiple * first: 1.0}),
        knob=lambda multiple: Knob(name, "amplitudes", DECADE, key=multiple * first),
    )  # fmt: skip
    if 1 in found.medians:
        part = ripple({multiple * first: median for multiple, median in found.medians.items()})
        yield Addition(
            kind="line_family", parts=(part,), knobs=tuple(found.knobs), starts=(tuple(found.start),),
            places=tuple(multiples.values()), log_odds=(_WHOLE if whole else _ANY) - log(len(context.shafts)),
            label=f"a torque at order {first:.6g} of {shaft.part}",
        )  # fmt: skip


def _swelling(context: Context) -> Iterator[Addition]:
    """Yield each clear line with those among its side lines that the model lacks, as torques on each shaft."""
    lacking = [line.place for line in context.lines if line.place.domain == "order"]
    places = [place for place in context.data.seen[0].places if place.domain == "order"]
    known = set[tuple[Place, ...]]()
    for middle in lacking[:_MIDDLES]:
        reach = reach_of(middle, places, slowest=min(shaft.turns for shaft in context.shafts))
        family = tuple(sorted(each for each in lacking if abs(each.at - middle.at) < reach))
        is_new = len(family) > 1 and family not in known
        known.add(family)
        for shaft in context.shafts if is_new else ():
            label = f"a torque at order {middle.at / shaft.turns:.6g} of {shaft.part} that swells"
            yield from torques(context, shaft, family, name="swelling_line", label=label, log_odds=_SWELLS)


def reach_of(middle: Place, places: Sequence[Place], *, slowest: float) -> float:
    """Return how far the side lines of a line reach [1/rev of the motor]; 0 where too few pairs of them are found.

    ``slowest`` are the turns of the slowest shaft per turn of the motor: what changes faster may be its teeth or balls.
    """
    near = [each.at - middle.at for each in places if each != middle and abs(each.at - middle.at) < _WIDEST * middle.at]
    most, reach = _FEWEST - 1, 0.0
    for step in map(abs, near):
        if not _APART * SAME_ORDER < step < _SLOWER * slowest:
            continue
        pairs = [
            multiple * step for multiple in range(1, _MOST_PAIRS + 1)
            if all(any(abs(each - way * multiple * step) < SAME_ORDER for each in near) for way in (-1, 1))
        ]  # fmt: skip
        if len(pairs) > most:
            most, reach = len(pairs), max(pairs) + SAME_ORDER
    return reach
