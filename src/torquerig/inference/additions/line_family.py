"""A nameless line and its multiples: a torque of constant amplitude on one of the shafts, whatever its cause."""

from __future__ import annotations

from collections.abc import Iterator
from math import log

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.inference.shafts import Shaft

_WHOLE, _ANY = (
    -6.0,
    -9.0,
)  # log-odds of a line at a whole order, and anywhere on the grid, on all shafts together
_HARMONICS = 6
_CLEAREST = 8  # lines; others follow when these are explained


def propose(context: Context) -> Iterator[Addition]:
    """Yield a family for each found order and each shaft on which its torque may act."""
    for line in context.lines[:_CLEAREST]:
        for shaft in context.shafts if line.place.domain == "order" else ():
            yield from _family(context, shaft, line.place)


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
