"""Sums, differences and multiples of the rig's lines: what contacts and springs that are not linear make of them.

A characteristic of second order turns two waves of orders a and b into waves of a + b, b - a, 2 a and 2 b, one of third
order adds 3 a; each is smaller than both waves it is made of. Source: any text on nonlinear vibration (Nayfeh & Mook
1979, Nonlinear Oscillations, 4). Every rig has them; they are no missing part.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations_with_replacement

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.inference.shafts import Shaft

_LOG_ODDS = -2.0
_SAME = 2e-3  # [1] relative: so near to a product an order is one
_MOST = 16  # lines of one family


def propose(context: Context) -> Iterator[Addition]:
    """Yield all found lines that are products of lines of the rig, as torques on each shaft."""
    found = [place for place in (line.place for line in context.lines) if _is_product(context, place)]
    for shaft in context.shafts if found else ():
        label = f"sums and differences of the rig's lines, as torques at {shaft.part}"
        yield from torques(context, shaft, found, name="line_products", label=label, log_odds=_LOG_ODDS)


def torques(
    context: Context, shaft: Shaft, places: Sequence[Place], *, name: str, label: str, log_odds: float
) -> Iterator[Addition]:
    """Yield lines at found orders as torques on a shaft, with independent sizes."""
    name, numbered = free_name(context.rig, name), dict(enumerate(places[:_MOST]))

    def ripple(amplitudes: dict[float, float]) -> mechanisms.TorqueRipple:
        return mechanisms.TorqueRipple(name=name, at=shaft.part, group="mechanical", amplitudes=amplitudes)

    def own(number: int) -> float:
        return numbered[number].at / shaft.turns

    found = harmonics(
        context, numbered, unit=lambda number: ripple({own(number): 1.0}),
        knob=lambda number: Knob(name, "amplitudes", DECADE, key=own(number)),
    )  # fmt: skip
    if found.medians:
        yield Addition(
            kind="line_family", parts=(ripple({own(number): size for number, size in found.medians.items()}),),
            knobs=tuple(found.knobs), starts=(tuple(found.start),),
            places=tuple(numbered[number] for number in found.medians), log_odds=log_odds, label=label,
        )  # fmt: skip


def _is_product(context: Context, place: Place) -> bool:
    if place.domain != "order":
        return False
    own, parents = _largest(context, place), _parents(context)
    for one, other in combinations_with_replacement(sorted(parents), 2):
        made = [one + other, other - one, 2 * one, 2 * other] if one < other else [2 * one, 3 * one]
        if own < min(parents[one], parents[other]) and any(abs(place.at - at) < _SAME * place.at for at in made):
            return True
    return False


def _parents(context: Context) -> dict[float, float]:
    """Return the orders of the rig's lines with their largest amplitudes [N m]."""
    lacking = {line.place for line in context.lines}
    places = [place for place in context.data.seen[0].places if place.domain == "order" and place not in lacking]
    return {place.at: _largest(context, place) for place in places}


def _largest(context: Context, place: Place) -> float:
    """Return the largest amplitude of a line in the recordings [N m]."""
    power = [seen.lines.power[:, seen.places.index(place)] for seen in context.data.seen if place in seen.places]
    return float(np.sqrt(np.nanmax(np.concatenate([*power, np.zeros(1)]))))
