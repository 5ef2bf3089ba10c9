"""Drop moves of the search: a mechanism that later additions make needless leaves the model.

The first addition of a search explains what it can, also of effects that are not its cause. A name is kept only if the
model with it wins by as much as a new name must, compared with the model that has all the other additions without it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

from torquerig.inference.addition import Addition
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.fit import Data
from torquerig.inference.knobs import Knob
from torquerig.inference.model import Model
from torquerig.inference.refitted import refitted


def without_needless(
    model: Model, data: Data, lines: Sequence[FoundLine], *, wins: Callable[[Addition, Model, Model], bool]
) -> Model:
    """Return the model without the mechanisms, other than the last addition, that no longer win.

    ``wins`` says whether an addition does, from the models with it and without it. ``lines`` are all found lines; those
    of what was dropped are unexplained again.
    """
    for each in model.additions[:-1]:
        if not each.is_named:
            continue
        names = frozenset(part.name for part in each.parts)
        fit = refitted(model.fit, data, keeps=partial(_is_of_others, names), without=names)
        if fit is None:
            continue
        rest = tuple(other for other in model.additions if other is not each)
        taken = {place for other in rest for place in other.places}
        less = replace(
            model, fit=fit, additions=rest, lines=tuple(line for line in lines if line.place not in taken),
            alternatives=tuple(row for row in model.alternatives if row[0] is not each),
        )  # fmt: skip
        if not wins(each, model, less):
            model = less
    return model


def _is_of_others(names: frozenset[str], knob: Knob) -> bool:
    return knob.part not in names
