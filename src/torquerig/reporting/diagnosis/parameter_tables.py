"""Tables of fitted parameters, each in the unit that its part declares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import exp
from typing import Any, Protocol, get_args, get_type_hints

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.knobs import Knob
from torquerig.parameter import Parameter
from torquerig.reporting.layout import Cell, Table, number, plain
from torquerig.rig.assembly import Rig
from torquerig.units import in_unit


class Fitted(Protocol):
    """A model with fitted parameters."""

    @property
    def rig(self) -> Rig:
        """With every parameter at its estimate."""

    @property
    def knobs(self) -> tuple[Knob, ...]:
        """The parameters."""

    @property
    def positions(self) -> NDArray[np.float64]:
        """Their estimates, in standard deviations from where the fit began; shape (knobs,)."""

    @property
    def covariance(self) -> NDArray[np.float64]:
        """Of the positions, shape (knobs, knobs)."""


_AS_DECLARED: Mapping[str, str] = {}


def fitted_parameters_table(
    nominal: Rig, before: Fitted, after: Fitted, *, unit_names: Mapping[str, str] = _AS_DECLARED
) -> Table:
    """Return every fitted parameter of the nominal model with prior and posterior.

    ``unit_names`` holds other names for declared units, such as those of a rig that moves in a line.
    """
    return Table(
        caption="Parameters of the nominal model, fitted before any mechanism is added",
        head=("parameter", "nominal", "prior SD", "fitted", "with findings", "posterior SD", "unit"),
        rows=tuple(tuple(_parameter_row(knob, nominal, before, after, unit_names)) for knob in before.knobs),
        note="Prior SD: standard deviation that the scenario states. Posterior SD: standard deviation given scenario "
        "and recordings. Highlighted: parameters that moved by more than two prior standard deviations.",
    )  # fmt: skip


def _parameter_row(
    knob: Knob, nominal: Rig, before: Fitted, after: Fitted, unit_names: Mapping[str, str]
) -> Iterator[Cell]:
    unit = unit_of(nominal.part(knob.part), knob.field)
    model = after if knob in after.knobs else before
    place = model.knobs.index(knob)
    yield Cell(text=knob.name.replace("_", " "))
    yield number(_formatted(knob.value(nominal), unit))
    yield number(_standard_deviation(knob, knob.spread, unit))
    yield number(_formatted(knob.value(before.rig), unit))
    moved = abs(float(model.positions[place])) > 2
    yield number(_formatted(knob.value(after.rig), unit), style="background:#fdf0c4" if moved else "")
    yield number(_posterior(knob, model, unit))
    yield _unit(unit, unit_names)


def added_parameters_table(
    before: Fitted, after: Fitted, *, unit_names: Mapping[str, str] = _AS_DECLARED
) -> Table | None:
    """Return the fitted parameters of the findings, or None if there are none."""
    rows = []
    for knob in after.knobs:
        if knob not in before.knobs:
            unit = unit_of(after.rig.part(knob.part), knob.field)
            rows.append((Cell(text=knob.name.replace("_", " ")), number(_formatted(knob.value(after.rig), unit)),
                         number(_posterior(knob, after, unit)), _unit(unit, unit_names)))  # fmt: skip
    if not rows:
        return None
    return Table(
        caption="Parameters of the findings in the completed scenario",
        head=("parameter", "fitted", "SD", "unit"), rows=tuple(rows), note="SD: one standard deviation.",
    )  # fmt: skip


def _unit(unit: str, unit_names: Mapping[str, str]) -> Cell:
    return Cell(text="" if unit == "1" else unit_names.get(unit, unit))


def _posterior(knob: Knob, model: Fitted, unit: str) -> str:
    place = model.knobs.index(knob)
    sigma = float(np.sqrt(max(model.covariance[place, place], 0.0)))
    return _standard_deviation(knob, knob.spread * min(sigma, 1.0), unit)


def _formatted(value: float, unit: str) -> str:
    return plain(in_unit(value, unit), 4)


def _standard_deviation(knob: Knob, sigma: float, unit: str) -> str:
    return f"{100 * (exp(sigma) - 1):.1f} %" if knob.factor else f"± {_formatted(sigma, unit)}"


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
