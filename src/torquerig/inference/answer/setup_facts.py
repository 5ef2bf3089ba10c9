"""Facts of the set-up and fitted numbers in the form of the contract."""

from __future__ import annotations

from typing import Any

from torquerig.inference.addition import Addition
from torquerig.inference.answer.confidence import ALIKE, alternatives, confidence
from torquerig.inference.answer.numbers import MOST_SURE, digits, estimate
from torquerig.inference.engine import Outcome
from torquerig.inference.fit import Fit
from torquerig.inference.knobs import Knob, declared
from torquerig.inference.readings import SetupFault

_SAME_TERM = {"coulomb": "stribeck_friction"}  # fields whose torque a mechanism adds: more of it is either of the two
_KIND_OF = {"scale": "sensor_scale", "zero": "sensor_zero"}  # fields of a sensor that are facts of the set-up


def fault_answer(each: SetupFault, fit: Fit) -> dict[str, Any]:
    """Return a fault of the set-up in the form of the contract; ``fit`` is that of the corrected runs."""
    return {
        "kind": each.kind, "of": each.of, "stated": digits(each.stated), "estimated": _estimated(each, fit),
        "confidence": MOST_SURE,  # of the class: the kind together with those that explain the features as well
        "equivalent_to": list(each.equivalent_to), "explanation": each.explanation,
    }  # fmt: skip


def _estimated(each: SetupFault, fit: Fit) -> dict[str, Any]:
    """Return the estimate of a fault with its interval; a scale is a parameter of the fit, a sign is certain."""
    scale = [at for at, knob in enumerate(fit.knobs) if (knob.part, knob.field) == (each.of, "scale")]
    if each.kind == "sensor_scale" and scale:
        return estimate(fit, scale[0], each.unit)
    low, high = each.interval or (each.estimated, each.estimated)
    return {"value": digits(each.estimated), "ci95": [digits(low), digits(high)], "unit": each.unit}


def number_answer(outcome: Outcome, each: Addition) -> dict[str, Any]:
    """Return a number of the rig that is far from its stated value, in the form of the contract.

    Other numbers and mechanisms that the recordings do not exclude in its place are alternatives; so is a mechanism
    that adds the same term to the rig, where the number is larger than stated.
    """
    fit, knob = outcome.model.fit, each.knobs[0]
    estimated = estimate(fit, [one.name for one in fit.knobs].index(knob.name), _unit_of(fit, knob))
    near = [other for other, gap in alternatives(outcome, each) if gap < ALIKE and (other.is_named or not other.parts)]
    numbers = [other.knobs[0].name for other in near if not other.is_named]
    stated = knob.value(fit.nominal)
    same = {_SAME_TERM[knob.field]} if knob.field in _SAME_TERM and estimated["value"] > stated else set[str]()
    instead = f" They do not exclude that {' or '.join(numbers)} is off instead." if numbers else ""
    return {
        "kind": _kind_of(each),
        "of": knob.part if knob.field in _KIND_OF else knob.name,
        "stated": digits(stated),
        "estimated": estimated,
        "confidence": round(confidence(outcome, each), 3),
        "equivalent_to": sorted(({_kind_of(other) for other in near} | same) - {_kind_of(each)}),
        "explanation": f"The recordings fit if {knob.name} is {estimated['value']:g} instead of "
        f"{stated:.4g}{'' if estimated['unit'] == '1' else ' ' + estimated['unit']}.{instead}",
    }  # fmt: skip


def _kind_of(each: Addition) -> str:
    return each.mechanism or _KIND_OF.get(each.knobs[0].field, "parameter")


def _unit_of(fit: Fit, knob: Knob) -> str:
    """Return the unit in which the class of a part declares a field."""
    known = declared(fit.nominal.part(knob.part), knob.field)
    return known.unit if known else "1"
