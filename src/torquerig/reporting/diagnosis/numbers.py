"""The tables of fitted numbers, each in the unit that its part declares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import exp
from typing import Any, get_args, get_type_hints

import numpy as np

from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.knobs import Knob
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.parameter import Parameter
from torquerig.reporting.layout import Cell, Table, number, plain
from torquerig.rig.assembly import Rig
from torquerig.units import in_unit

Fitted = Calibrated | FittedMotion
_AS_DECLARED: Mapping[str, str] = {}


def numbers_table(nominal: Rig, before: Fitted, after: Fitted, *, called: Mapping[str, str] = _AS_DECLARED) -> Table:
    """Return every number of the nominal model that was fitted: nominal, stated spread, fitted before and after.

    ``called`` holds other names for declared units, such as those of a rig that moves in a line.
    """
    return Table(
        caption="The model's own numbers, fitted before anything is called missing",
        head=("number", "nominal", "stated spread", "fitted", "with what was found", "known to", "unit"),
        rows=tuple(tuple(_number(knob, nominal, before, after, called)) for knob in before.knobs),
        note="Known to: one sigma that the recordings leave, together with the stated spread. A number that moved by "
        "more than two of its stated spreads is marked.",
    )  # fmt: skip


def _number(knob: Knob, nominal: Rig, before: Fitted, after: Fitted, called: Mapping[str, str]) -> Iterator[Cell]:
    unit = unit_of(nominal.part(knob.part), knob.field)
    model = after if knob in after.knobs else before
    place = model.knobs.index(knob)
    yield Cell(text=knob.name.replace("_", " "))
    yield number(_shown(knob.value(nominal), unit))
    yield number(_spread(knob, knob.spread, unit))
    yield number(_shown(knob.value(before.rig), unit))
    moved = abs(float(model.positions[place])) > 2
    yield number(_shown(knob.value(after.rig), unit), style="background:#fdf0c4" if moved else "")
    yield number(_known(knob, model, unit))
    yield _unit(unit, called)


def added_numbers_table(before: Fitted, after: Fitted, *, called: Mapping[str, str] = _AS_DECLARED) -> Table | None:
    """Return the numbers of what was added to the model, or None where none of its numbers is fitted with it."""
    rows = []
    for knob in after.knobs:
        if knob not in before.knobs:
            unit = unit_of(after.rig.part(knob.part), knob.field)
            rows.append((Cell(text=knob.name.replace("_", " ")), number(_shown(knob.value(after.rig), unit)),
                         number(_known(knob, after, unit)), _unit(unit, called)))  # fmt: skip
    if not rows:
        return None
    return Table(
        caption="The numbers of what was found, as they stand in the completed scenario",
        head=("number", "fitted", "known to", "unit"), rows=tuple(rows), note="Known to: one sigma.",
    )  # fmt: skip


def _unit(unit: str, called: Mapping[str, str]) -> Cell:
    return Cell(text="" if unit == "1" else called.get(unit, unit))


def _known(knob: Knob, model: Fitted, unit: str) -> str:
    place = model.knobs.index(knob)
    sigma = float(np.sqrt(max(model.covariance[place, place], 0.0)))
    return _spread(knob, knob.spread * min(sigma, 1.0), unit)


def _shown(value: float, unit: str) -> str:
    return plain(in_unit(value, unit), 4)


def _spread(knob: Knob, sigma: float, unit: str) -> str:
    return f"{100 * (exp(sigma) - 1):.1f} %" if knob.factor else f"± {_shown(sigma, unit)}"


def unit_of(part: Any, field: str) -> str:
    """Return the unit that a part declares for a field, ``1`` where it declares none."""
    found = next(_declared(get_type_hints(type(part), include_extras=True)[field]), None)
    return "1" if found is None else found.unit


def _declared(hint: Any) -> Iterator[Parameter]:
    for each in getattr(hint, "__metadata__", ()):
        if isinstance(each, Parameter):
            yield each
    for inner in get_args(hint):
        yield from _declared(inner)
