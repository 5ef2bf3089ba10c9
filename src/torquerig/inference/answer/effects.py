"""Findings and nameless effects in the form of the contract."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from typing import Any

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported
from torquerig.inference.answer.confidence import alternatives, confidence, equivalent_to, mechanisms_alike
from torquerig.inference.answer.numbers import digits, estimate
from torquerig.inference.answer.owned import Owned
from torquerig.inference.answer.sizes import is_minor, size
from torquerig.inference.answer.tried import alternatives_of
from torquerig.inference.engine import Outcome
from torquerig.inference.shafts import shafts_of
from torquerig.rig.assembly import Part
from torquerig.rig.reading_place import effort_unit


def finding(outcome: Outcome, each: Addition, *, next_experiment: str | None) -> dict[str, Any]:
    """Return a mechanism that the model lacks."""
    return {
        "mechanism": each.mechanism,
        **({"variant": each.variant} if each.variant else {}),
        "part": next((place for part in each.parts if (place := _place(part))), ""),
        "explanation": f"The model lacks {each.label}.{_compared(outcome, each)}",
        "confidence": round(confidence(outcome, each), 3),
        "parameters": dict(_parameters(outcome, each)),
        "equivalent_to": equivalent_to(outcome, each),
        "next_experiment": next_experiment,
        "size": {"value": digits(size(outcome, each)), "unit": effort_unit(outcome.completed)},
        "alternatives": alternatives_of(outcome, each),
    }


def finding_of_number(outcome: Outcome, each: Addition, owner: Owned) -> dict[str, Any]:
    """Return a number of the scenario that belongs to a mechanism, as a finding."""
    return {
        "mechanism": owner.mechanism, "part": each.knobs[0].part, "explanation": owner.sentence,
        "confidence": round(confidence(outcome, each), 3), "parameters": owner.parameters,
        "equivalent_to": [name for name in mechanisms_alike(outcome, each) if name != owner.mechanism],
        "next_experiment": None,
        "size": {"value": digits(size(outcome, each)), "unit": effort_unit(outcome.completed)},
        "alternatives": alternatives_of(outcome, each),
    }  # fmt: skip


def unnamed(outcome: Outcome, each: Addition) -> dict[str, Any]:
    """Return an effect without a name; ``equivalent_to`` has the mechanisms that it may be."""
    axis, at = _axis(outcome, each)
    low, high, value = *_size_interval(outcome, each), size(outcome, each)
    peak = 2**0.5 if each.places else 1.0  # a line is stated by its amplitude, noise by its rms
    maybe = sorted({*mechanisms_alike(outcome, each), *([each.mechanism] if each.is_named else [])})
    return {
        "kind": each.kind or _kind(each), "axis": axis, "at": digits(at),
        "harmonics": [max(1, round(place.at / each.places[0].at)) for place in each.places],
        "acts_as": _acts_as(each.parts[0]),
        "size": {"value": digits(peak * value), "ci95": [digits(peak * value * low), digits(peak * value * high)],
                 "unit": effort_unit(outcome.completed)},
        "in_model": True, "minor": is_minor(outcome, each), "confidence": round(confidence(outcome, each), 3),
        "equivalent_to": maybe, "explanation": _nameless_sentence(each, maybe),
        "alternatives": alternatives_of(outcome, each),
    }  # fmt: skip


def _nameless_sentence(each: Addition, maybe: list[str]) -> str:
    if maybe:
        names = " or ".join(name.replace("_", " ") for name in maybe)
        return f"The recordings show {each.label}. It may be {names}; no name is sure enough."
    return f"The recordings show {each.label}. No mechanism of the library explains it."


def _compared(outcome: Outcome, each: Addition) -> str:
    """Return how far the best other hypothesis is behind."""
    second = next(iter(alternatives(outcome, each)), None)
    if second is None:
        return ""
    return f" The next best hypothesis, {second[0].label}, is {second[1]:.0f} nats less likely."


def _parameters(outcome: Outcome, each: Addition) -> Iterator[tuple[str, dict[str, Any]]]:
    for name, (value, half, unit) in each.fixed.items():
        yield name, {"value": digits(value), "ci95": [digits(value - half), digits(value + half)], "unit": unit}
    for name, (value, low, high, unit) in each.estimated.items():
        yield name, {"value": digits(value), "ci95": [digits(low), digits(high)], "unit": unit}
    for one in each.reported:
        column = _column(outcome, each, one)
        if column is not None:
            yield one.name, estimate(outcome.model.fit, column, one.unit)


def _column(outcome: Outcome, each: Addition, one: Reported) -> int | None:
    """Return the column of a reported parameter among those of the fit; None where it was not fitted."""
    part = each.parts[0].name
    return next(
        (at for at, knob in enumerate(outcome.model.fit.knobs)
         if (knob.part, knob.field, knob.key) == (part, one.field, one.key)), None,
    )  # fmt: skip


def _size_interval(outcome: Outcome, each: Addition) -> tuple[float, float]:
    """Return the ends of the 95 % interval of the first amplitude, relative to its estimate."""
    if not each.knobs:
        return 1.0, 1.0
    column = [knob.name for knob in outcome.model.fit.knobs].index(each.knobs[0].name)
    one = estimate(outcome.model.fit, column, "1")
    value = abs(one["value"]) or 1.0
    low, high = sorted(abs(end) / value for end in one["ci95"])
    return min(low, 1.0), max(high, 1.0)


def _axis(outcome: Outcome, each: Addition) -> tuple[str, float]:
    """Return the axis of a nameless effect and where on it; of a course a moment of the longest run or a speed."""
    if each.places:
        place = each.places[0]
        return ("motor_shaft" if place.domain == "order" else "Hz"), place.at
    part = outcome.completed.part(each.parts[0].name)
    if isinstance(part, mechanisms.ReadingCourse):
        return "s", part.at * max(run.recording.duration for run in outcome.runs)
    if isinstance(part, mechanisms.SpeedCourse):
        return "rpm", part.at * abs(shafts_of(outcome.completed)[-1].turns) * 30 / pi
    if isinstance(part, mechanisms.NoiseHump) and each.kind == "level_course":  # slow noise: its correlation time
        return "s", 1 / (2 * pi * part.frequency)
    return "Hz", float(getattr(part, "frequency", 0.0))


def _kind(each: Addition) -> str:
    """Return the nameless kind of a mechanism that is not named."""
    if not each.places:
        return "other"
    return "line_family" if each.places[0].domain == "order" else "tone"


def _place(part: Part) -> str:
    """Return the part that an effect sits in."""
    return str(
        next(
            (
                own
                for name in ("at", "gear", "coupling", "after", "sensor", "host")
                if (own := getattr(part, name, None))
            ),
            "",
        )
    )


def _acts_as(part: Part) -> str:
    at = getattr(part, "at", None)
    if isinstance(at, str) and at:
        return f"torque at {at}"
    if getattr(part, "gear", None):
        return f"angle error in {part.gear}"  # type: ignore[attr-defined]
    return "signal"
