"""Fitted parameters of findings, and numbers of the scenario that are far from their stated values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import pi
from typing import Any

import numpy as np

from torquerig.inference.answer.numbers import MOST_SURE, TWO_SIDED, digits
from torquerig.inference.knobs import Knob
from torquerig.inference.motion.engine import MotionOutcome, sizes_of
from torquerig.inference.motion.hypothesis import Hypothesis
from torquerig.rig.reading_place import effort_unit

_FAR = 4.0  # standard deviations of its prior: a number of the scenario beyond (6e-5) is wrong

FIELDS: Mapping[str, tuple[str, str, str]] = {  # field: name, unit where it turns, unit in a line
    "coulomb": ("coulomb_Nm", "N*m", "N"), "static": ("static_Nm", "N*m", "N"),
    "viscous": ("viscous_Nms", "N*m*s/rad", "N*s/m"), "stribeck_speed": ("stribeck_rad_s", "rad/s", "m/s"),
    "stiffness": ("stiffness", "N*m/rad", "N/m"), "gap": ("gap_arcmin", "arcmin", "m"),
    "coefficient": ("coefficient_Nms2", "N*m*s^2/rad^2", "N*s^2/m^2"), "frequency": ("frequency_Hz", "Hz", "Hz"),
    "inertia": ("inertia_kgm2", "kg*m^2", "kg"), "damping_ratio": ("damping_ratio", "1", "1"),
}  # fmt: skip


def parameters_of(outcome: MotionOutcome, own: Hypothesis) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the identifying parameters of a mechanism with their 95 % intervals."""
    line = effort_unit(outcome.completed) == "N"
    two_ways = any(knob.field == "coulomb_backward" for knob in own.knobs)
    for knob in own.knobs:
        if knob.field == "limit":
            channel = outcome.runs[0].channel
            yield "limit_V", _estimate(outcome, knob, channel.unit, factor=1 / abs(channel.si_per_unit))
        field, back = knob.field.removesuffix("_backward"), knob.field.endswith("_backward")
        if field not in FIELDS:
            continue
        name, turning, moving = FIELDS[field]
        if field == "gap" and line:
            name = "gap_m"
        side = "_backward" if back else "_forward" if two_ways and field in ("coulomb", "static", "viscous") else ""
        factor = 60 * 180 / pi if field == "gap" and not line else 1.0
        yield f"{name}{side}", _estimate(outcome, knob, moving if line else turning, factor=factor)
    if own.orders and own.mechanism == "cogging":
        yield from _largest_order(outcome, own)
    elif own.columns is not None:
        yield from _linear(outcome, own)


def far_parameters(outcome: MotionOutcome) -> Iterator[dict[str, Any]]:
    """Yield the numbers of the scenario whose estimate is beyond what its stated uncertainty allows."""
    for row, knob in enumerate(outcome.fit.model.nuisances):
        if abs(outcome.fit.positions[row]) < _FAR or knob.field == "smoothing":
            continue
        estimated = _estimate(outcome, knob, "1")
        stated = knob.value(outcome.fit.model.nominal)
        yield {
            "kind": "parameter", "of": knob.name, "stated": digits(stated), "estimated": estimated,
            "confidence": MOST_SURE, "equivalent_to": [],
            "explanation": f"The recordings fit if {knob.name} is {estimated['value']:.4g} instead of {stated:.4g}.",
        }  # fmt: skip


def delays(outcome: MotionOutcome) -> Iterator[dict[str, Any]]:
    """Yield the delay between motion and effort, where the model has one, as a fact of the set-up."""
    for each in outcome.fit.model.additions:
        if each.kind == "effort_delay":
            row = outcome.fit.names.index(f"{each.name}[0]")
            late, half = (float(each.scale * x) for x in (
                outcome.fit.positions[row], TWO_SIDED * np.sqrt(outcome.fit.covariance[row, row])))  # fmt: skip
            yield {
                "kind": "acquisition_filter", "of": outcome.runs[0].channel.quantity, "stated": 0.0,
                "estimated": {"value": digits(late), "ci95": [digits(late - half), digits(late + half)], "unit": "s"},
                "confidence": MOST_SURE, "equivalent_to": [],
                "explanation": f"The measured effort is {abs(1000 * late):.3g} ms {'later' if late > 0 else 'earlier'} "
                "than the measured motion.",
            }  # fmt: skip


def _estimate(outcome: MotionOutcome, knob: Knob, unit: str, *, factor: float = 1.0) -> dict[str, Any]:
    fit = outcome.fit
    row = fit.names.index(knob.name)
    half = TWO_SIDED * float(np.sqrt(fit.covariance[row, row]))
    median, at = knob.value(fit.model.rig), float(fit.positions[row])
    ends = sorted(factor * knob.turned(median, at + way * half) for way in (-1, 1))
    return {"value": digits(factor * knob.turned(median, at)), "ci95": [digits(end) for end in ends], "unit": unit}


def _largest_order(outcome: MotionOutcome, own: Hypothesis) -> Iterator[tuple[str, dict[str, Any]]]:
    sizes = sizes_of(outcome.fit, own.name, scale=own.scale).reshape(-1, 2)
    amplitudes = np.hypot(*sizes.T)
    largest = int(np.argmax(amplitudes))
    rows = [outcome.fit.names.index(f"{own.name}[{2 * largest + way}]") for way in (0, 1)]
    half = TWO_SIDED * own.scale * float(np.sqrt(np.trace(outcome.fit.covariance[np.ix_(rows, rows)]) / 2))
    order, channel = own.orders[largest], outcome.runs[0].channel
    yield "order_motor", {"value": order, "ci95": [order - 0.01, order + 0.01], "unit": "1/rev"}
    units = {"amplitude_Nm": (1.0, "N*m")}
    if channel.unit == "A":
        units["amplitude_A"] = (1 / abs(channel.si_per_unit), "A")
    for name, (factor, unit) in units.items():
        value = float(amplitudes[largest])
        yield name, {"value": digits(factor * value), "unit": unit,
                     "ci95": [digits(factor * (value - half)), digits(factor * (value + half))]}  # fmt: skip


def _linear(outcome: MotionOutcome, own: Hypothesis) -> Iterator[tuple[str, dict[str, Any]]]:
    rows = [row for row, name in enumerate(outcome.fit.names) if name.startswith(f"{own.name}[")]
    half = TWO_SIDED * own.scale * float(np.sqrt(outcome.fit.covariance[rows[0], rows[0]]))
    value = float(np.linalg.norm(sizes_of(outcome.fit, own.name, scale=own.scale)[:2]))
    channel, unit = outcome.runs[0].channel, effort_unit(outcome.completed)
    factor = 1 / abs(channel.si_per_unit) if channel.unit == "V" else 1.0
    if own.axis == "Hz":
        yield "frequency_Hz", {"value": own.at, "ci95": [own.at, own.at], "unit": "Hz"}
    yield "amplitude_V" if own.axis == "Hz" else "span_V", {
        "value": digits(factor * value), "unit": "V" if channel.unit == "V" else unit,
        "ci95": [digits(factor * (value - half)), digits(factor * (value + half))],
    }  # fmt: skip
