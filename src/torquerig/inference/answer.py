"""The answer of a diagnosis as JSON, in the form of the contract with the additions for nameless effects and set-up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import exp, log10, pi
from typing import Any

import numpy as np

from torquerig.diagnosis.looking.places import Place
from torquerig.inference.addition import Addition, Reported
from torquerig.inference.adequacy import LEVEL_OF_TEST, Excess, excesses
from torquerig.inference.engine import Outcome
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit, all_residuals
from torquerig.inference.likelihood import BAND, LEVEL, LINE
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.inference.setup_answer import MOST_SURE, TWO_SIDED, digits, estimate, fault_answer, number_answer

SCHEMA = "torquerig.diagnosis/1"
RELEVANCE = 0.03  # [1] of the signal's standard deviation: a smaller nameless effect changes no verdict
_METRIC = (
    "Mean squared standardised residual of held-out data; about 1 for a true model. The data are the logarithms of the "
    "power of lines and of the density of bands, and mean torques, each divided by its standard deviation: sampling "
    "error and what a right model may be wrong by."
)


def as_json(outcome: Outcome) -> dict[str, Any]:
    """Return the answer in the contract's form."""
    model = outcome.model
    left = [each for each in _left(outcome) if each.p_value < LEVEL_OF_TEST]
    named = [each for each in model.additions if each.is_named]
    numbers = [each for each in model.additions if each.kind == "parameter"]
    nameless = [each for each in model.additions if not each.is_named and each.kind != "parameter"]
    minor = {id(each) for each in nameless if _size(outcome, each) < RELEVANCE * _signal(outcome)}
    before, nominal = _held_residual(outcome.nominal, outcome.held), _unfitted_residual(outcome)
    after = _held_residual(model.fit, outcome.held)
    return {
        "schema": SCHEMA,
        "verdict": _verdict(
            named, [*outcome.setup, *numbers], [each for each in nameless if id(each) not in minor], left
        ),
        "mismatch": [*_mismatches(outcome), *(_leftover(outcome, each) for each in left)],
        "findings": [_finding(outcome, each) for each in named],
        "setup": [*map(fault_answer, outcome.setup), *(_number(outcome, each) for each in numbers)],
        "unnamed": [_unnamed(outcome, each, minor=id(each) in minor) for each in nameless],
        "fit": {
            "metric": _METRIC,
            "before": {"heldout_misfit": digits(before), "nominal": digits(nominal)},
            "after": {"heldout_misfit": digits(after)},
            "improvement": {"value": digits(1 - after / before), "ci95": _improvement(outcome)},
        },
        "model": None,
        "recordings": [
            {"file": run.name, "speed_rpm": digits(float(np.mean(run.speed)) * 30 / pi), "used_for": "split"}
            for run in outcome.runs
        ],
    }


def _verdict(
    named: Sequence[Addition], numbers: Sequence[object], nameless: Sequence[Addition], left: Sequence[Excess]
) -> str:
    if left or nameless:
        return "unexplained"
    if named:
        return "missing_physics"
    return "setup_error" if numbers else "adequate"


def _left(outcome: Outcome) -> tuple[Excess, ...]:
    """Return what the completed model leaves of the fitted data."""
    fit = outcome.model.fit
    return excesses(all_residuals(outcome.data, fit.expected, fit.gains, fit.off))


def _standardised(fit: Fit, data: Data) -> np.ndarray[Any, np.dtype[np.float64]]:
    rig = fit.fitted_rig
    expected = [expected_run(rig, seen) for seen in data.seen]
    return np.concatenate([each.standardised for each in all_residuals(data, expected, fit.gains, fit.off)])


def _held_residual(fit: Fit, held: Data) -> float:
    return float(np.mean(_standardised(fit, held) ** 2))


def _unfitted_residual(outcome: Outcome) -> float:
    """Return the held-out residual of the scenario as it is stated."""
    fit, held = outcome.nominal, outcome.held
    expected = [expected_run(fit.nominal, seen) for seen in held.seen]
    each = all_residuals(held, expected, np.zeros_like(fit.gains), fit.off)
    return float(np.mean(np.concatenate([one.standardised for one in each]) ** 2))


def _improvement(outcome: Outcome) -> list[float]:
    """Return the 95 % interval of the improvement: by the scatter of the residuals over the held-out features."""
    before = _standardised(outcome.nominal, outcome.held) ** 2
    after = _standardised(outcome.model.fit, outcome.held) ** 2
    share = 1 - after.mean() / before.mean()
    scatter = np.std(after - (1 - share) * before) / (before.mean() * np.sqrt(before.size))
    return [digits(float(share - TWO_SIDED * scatter)), digits(float(share + TWO_SIDED * scatter))]


def _signal(outcome: Outcome) -> float:
    return max(float(np.std(run.torque)) for run in outcome.runs)


def _size(outcome: Outcome, each: Addition) -> float:
    """Return the rms of an addition in the reading [N m], the largest one of the runs."""
    fit, rig = outcome.model.fit, outcome.completed
    without = rig
    for part in each.parts:
        without = without.without(part.name)
    largest = 0.0
    for seen, own in zip(outcome.data.seen, fit.expected, strict=True):
        other = expected_run(without, seen)
        lines = 0.5 * np.maximum(own.line_power - other.line_power, 0.0).sum(axis=1)
        width = seen.bands.high - seen.bands.low
        noise = (np.maximum(own.density - other.density, 0.0) * width).sum(axis=1)
        largest = max(largest, float(np.sqrt((lines + noise).max(initial=0.0))))
    return largest


def _confidence(outcome: Outcome, each: Addition) -> float:
    """Return the posterior probability of an addition among what was fitted in its place."""
    others = sum(exp(-gap) for added, _, gap in outcome.model.alternatives if added is each)
    return min(1 / (1 + others), MOST_SURE)


def _equivalent(outcome: Outcome, each: Addition) -> list[str]:
    """Return the other mechanisms whose odds are within 20 to 1 of an addition."""
    near = [other for added, other, gap in outcome.model.alternatives if added is each and gap < np.log(20)]
    return sorted({other.mechanism for other in near if other.is_named and other.mechanism != each.mechanism})


def _finding(outcome: Outcome, each: Addition) -> dict[str, Any]:
    rejected = [(other.label, gap) for added, other, gap in outcome.model.alternatives if added is each]
    second = min(rejected, key=lambda one: one[1], default=None)
    compared = "" if second is None else f" The next best hypothesis, {second[0]}, is {second[1]:.0f} nats less likely."
    return {
        "mechanism": each.mechanism,
        "part": next((str(getattr(part, "at", part.host) or "") for part in each.parts), ""),
        "explanation": f"The model lacks {each.label}.{compared}",
        "confidence": round(_confidence(outcome, each), 3),
        "parameters": dict(_parameters(outcome, each)),
        "equivalent_to": _equivalent(outcome, each),
        "next_experiment": None,
        "size": {"value": digits(_size(outcome, each)), "unit": "N*m"},
    }


def _parameters(outcome: Outcome, each: Addition) -> Iterator[tuple[str, dict[str, Any]]]:
    for name, (value, half, unit) in each.fixed.items():
        yield name, {"value": digits(value), "ci95": [digits(value - half), digits(value + half)], "unit": unit}
    for one in each.reported:
        yield one.name, _interval(outcome, each.parts[0].name, one)


def _interval(outcome: Outcome, part: str, one: Reported) -> dict[str, Any]:
    """Return a fitted parameter with its interval, by the covariance of the posterior."""
    fit = outcome.model.fit
    column = next(
        at for at, knob in enumerate(fit.knobs) if (knob.part, knob.field, knob.key) == (part, one.field, one.key)
    )
    return estimate(fit, column, one.unit)


def _number(outcome: Outcome, each: Addition) -> dict[str, Any]:
    return number_answer(outcome.model.fit, each.knobs[0], confidence=_confidence(outcome, each))


def _unnamed(outcome: Outcome, each: Addition, *, minor: bool) -> dict[str, Any]:
    part, size = each.parts[0], _size(outcome, each)
    axis, at = _axis(outcome, each)
    acts = f"torque at {getattr(part, 'at', '')}" if each.kind == "line_family" else "signal"
    return {
        "kind": each.kind, "axis": axis, "at": digits(at),
        "harmonics": [max(1, round(place.at / each.places[0].at)) for place in each.places], "acts_as": acts,
        "size": {"value": digits(size * 2**0.5 if each.places else size), "unit": "N*m"}, "in_model": True,
        "minor": minor, "confidence": round(_confidence(outcome, each), 3), "equivalent_to": [],
        "explanation": f"The recordings show {each.label}. No mechanism of the library explains it.",
    }  # fmt: skip


def _axis(outcome: Outcome, each: Addition) -> tuple[str, float]:
    if each.places:
        place = each.places[0]
        return ("motor_shaft" if place.domain == "order" else "Hz"), place.at
    return "Hz", float(getattr(outcome.completed.part(each.parts[0].name), "frequency", 0.0))


def _mismatches(outcome: Outcome) -> Iterator[dict[str, Any]]:
    """Yield where the nominal model is wrong: the places of the additions."""
    for each in outcome.model.additions:
        for place in each.places:
            yield _of_place(outcome, place)


def _of_place(outcome: Outcome, place: Place) -> dict[str, Any]:
    excess, runs = 0.0, list[str]()
    for seen in outcome.data.seen:
        column = seen.places.index(place)
        for segment in seen.segments:
            if segment.line_count[column] > 0:
                noise = float(
                    np.interp(seen.line_frequency[0, column], seen.bands.middle, np.nan_to_num(segment.bands.power))
                )
                floor = max(noise * float(segment.line_noise_bandwidth[column]), 1e-300)
                excess = max(excess, 10 * log10(max(float(segment.line_power[column]), 1e-300) / floor))
                runs += [seen.run.name] if seen.run.name not in runs else []
    turning = place.domain == "order"
    return {
        "domain": place.domain, "axis": "motor_shaft" if turning else "Hz", "at": digits(place.at),
        "width": 0.01 if turning else 1.0, "recordings": runs, "excess_dB": digits(excess),
        "share_of_misfit": digits(_share(outcome, place)),
        "p_value": 0.0,
    }  # fmt: skip


def _leftover(outcome: Outcome, each: Excess) -> dict[str, Any]:
    """Return where the completed model is still wrong."""
    fit = outcome.model.fit
    seen = outcome.data.seen[each.run]
    residual = all_residuals(outcome.data, fit.expected, fit.gains, fit.off)[each.run]
    at, decibels = int(residual.at[each.row]), 10 * float(residual.value[each.row]) / np.log(10)
    domain, axis, middle, width = _where(seen, each.kind, at)
    return {
        "domain": domain, "axis": axis, "at": digits(middle), "width": digits(width), "recordings": [seen.run.name],
        "excess_dB": digits(decibels) if each.kind != LEVEL else None, "share_of_misfit": None,
        "p_value": digits(each.p_value),
    }  # fmt: skip


def _where(seen: RunFeatures, kind: int, at: int) -> tuple[str, str, float, float]:
    """Return domain, axis, middle and width of a feature."""
    if kind == BAND:
        return "frequency", "Hz", float(seen.bands.middle[at]), float(seen.bands.high[at] - seen.bands.low[at])
    if kind == LEVEL:
        return "time", "s", float(seen.parts[at].mean()) / seen.run.rate, float(seen.level_duration[at])
    place = seen.places[at]
    turning = place.domain == "order"
    return place.domain, "motor_shaft" if turning else "Hz", place.at, 0.01 if turning else 1.0


def _share(outcome: Outcome, place: Place) -> float:
    """Return the share of the nominal model's squared residuals at a place [1]."""
    fit, total, there = outcome.nominal, 0.0, 0.0
    for seen, each in zip(
        outcome.data.seen, all_residuals(outcome.data, fit.expected, fit.gains, fit.off), strict=True
    ):
        square = each.standardised**2
        total += float(square.sum())
        there += float(square[(each.kind == LINE) & (each.at == seen.places.index(place))].sum())
    return there / total
