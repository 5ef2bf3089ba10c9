"""Hypotheses of which only one size is unknown: where it begins and its prior follow from one found line."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from torquerig.inference.addition import DECADE, Addition, start_of
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.rig.assembly import Part


def one_size(
    context: Context, part: Callable[[float], Part], *, field: str, place: Place, places: Iterable[Place] = (),
    key: int | float | None = None, unit: float = 1.0, power: float = 1.0, **said: Any,
) -> Iterator[Addition]:  # fmt: skip
    """Yield the hypothesis, or nothing where its part makes no line at ``place``.

    Parameters
    ----------
    part : callable
        From a size to the part.
    field, key : str, int or float
        Which number of the part the size is.
    place : Place
        The found line that the size is estimated from.
    places : iterable of Place
        All found lines that it explains; by default ``place``.
    unit, power : float
        The part of this size is evaluated; lines grow by so much a power of the size, as sizes go to 0.
    said : Any
        Further fields of the addition.
    """
    factor, median = context.size_of(part(unit), place)
    if median:
        middle, value = unit * median ** (1 / power), unit * factor ** (1 / power)
        name = part(unit).name
        yield Addition(
            parts=(part(middle),), knobs=(Knob(name, field, DECADE / power, key=key),),
            starts=((start_of(value, middle, DECADE / power),),), places=tuple(places) or (place,), **said,
        )  # fmt: skip
