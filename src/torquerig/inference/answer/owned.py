"""Numbers of the scenario that belong to a mechanism: a wrong one is a finding, no fact of the set-up.

A drag that is stated too small and a drag that is missing are the same physics; so are a gap, a bandwidth, a ripple.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any, NamedTuple

from torquerig.inference.addition import Addition
from torquerig.inference.answer.numbers import digits, estimate
from torquerig.inference.engine import Outcome
from torquerig.rig.assembly import Part

_ARCMIN = 180 * 60 / pi
_BY_KIND = frozenset(
    {"blade_pass", "cogging", "commutation_ripple", "gear_mesh", "quadratic_drag", "stribeck_friction"}
)
_BY_GROUP = {"cogging": "cogging", "electrical": "commutation_ripple"}  # of a stated torque ripple
_BY_FIELD: dict[str, tuple[str, Callable[[float, float], bool]]] = {
    "bandwidth": ("sensor_bandwidth", lambda estimated, stated: estimated < stated),
    "backlash": ("backlash", lambda estimated, stated: estimated > stated),
}
_REPORTED = {
    "depth": ("depth", "1", 1.0), "amplitude": ("amplitude_Nm", "N*m", 1.0), "amplitudes": ("amplitude_Nm", "N*m", 1.0),
    "coefficient": ("coefficient_Nms2", "N*m*s^2/rad^2", 1.0), "bandwidth": ("cutoff_Hz", "Hz", 1.0),
    "transmission_error": ("transmission_error_rad", "rad", 1.0), "coulomb": ("coulomb_Nm", "N*m", 1.0),
    "static": ("static_Nm", "N*m", 1.0), "stribeck_speed": ("stribeck_rad_s", "rad/s", 1.0),
    "backlash": ("gap_arcmin", "arcmin", _ARCMIN),
}  # fmt: skip
"""Contract's name and unit of each field, and the factor to that unit."""


class Owned(NamedTuple):
    """The mechanism that a number belongs to, and its parameter in the contract's form."""

    mechanism: str
    parameters: dict[str, dict[str, Any]]
    sentence: str


def owned(outcome: Outcome, each: Addition) -> Owned | None:
    """Return the mechanism that a far number of the scenario belongs to; None where none owns it."""
    knob, fit = each.knobs[0], outcome.model.fit
    if knob.field not in _REPORTED:
        return None
    column = [one.name for one in fit.knobs].index(knob.name)
    name, unit, factor = _REPORTED[knob.field]
    found, stated = estimate(fit, column, unit), knob.value(fit.nominal)
    mechanism = _owner(fit.nominal.part(knob.part), knob.field, found["value"], stated)
    if not mechanism:
        return None
    scaled = {"value": digits(factor * found["value"]), "ci95": [digits(factor * end) for end in found["ci95"]]}
    order = {} if not isinstance(knob.key, float) else {"order_motor": _exact(knob.key)}
    spoken = "" if unit == "1" else f" {unit.replace('*', ' ')}"
    sentence = f"The scenario states {digits(factor * stated)}{spoken} for {knob.name}; the recordings show "
    return Owned(mechanism, {**order, name: {**scaled, "unit": unit}}, f"{sentence}{scaled['value']:g}{spoken}.")


def _owner(part: Part, field: str, estimated: float, stated: float) -> str:
    if part.kind in _BY_KIND:
        return part.kind
    if part.kind == "torque_ripple":
        return _BY_GROUP.get(str(getattr(part, "group", "")), "")
    mechanism, exceeds = _BY_FIELD.get(field, ("", lambda *_: False))
    return mechanism if exceeds(estimated, stated) else ""


def _exact(order: float) -> dict[str, Any]:
    return {"value": digits(order), "ci95": [digits(order)] * 2, "unit": "1/rev"}
