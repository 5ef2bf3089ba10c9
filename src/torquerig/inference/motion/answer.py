"""The answer of a diagnosis under measured motion, in the contract's form."""

from __future__ import annotations

from collections.abc import Iterator
from math import exp, log10, pi
from typing import Any

import numpy as np

from torquerig.inference.answer.confidence import ALIKE, LEAST
from torquerig.inference.answer.document import SCHEMA
from torquerig.inference.answer.numbers import MOST_SURE, TWO_SIDED, digits
from torquerig.inference.motion.engine import MotionOutcome
from torquerig.inference.motion.hypothesis import Hypothesis
from torquerig.inference.motion.imposed_run import ImposedRun
from torquerig.inference.motion.parameters_found import delays, far_parameters, parameters_of
from torquerig.inference.motion.search import LEAST_GAIN, Step
from torquerig.inference.motion.sizes import amplitude, held_out_effort, held_out_rms, relevance, size
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.reading_place import effort_unit

METRIC = (
    "Rms residual of held-out data, relative to the rms of the measured torque or force. The residual is measured "
    "minus simulated, below a tenth of the sample rate, with the recorded motion imposed. 0 is a perfect model; 1 is a "
    "model that predicts zero."
)
_KINDS = {"line_family": "line_family", "tone": "tone", "slow_course": "level_course"}
_DOMAINS = {"motor_shaft": "order", "cycles/m": "order", "Hz": "frequency", "time": "time", "speed": "speed",
            "position": "level", "": "level"}  # fmt: skip


def as_json(outcome: MotionOutcome) -> dict[str, Any]:
    """Return the answer in the contract's form."""
    return {
        "schema": SCHEMA, "verdict": verdict(outcome),
        "mismatch": sorted((_place(outcome, step) for step in outcome.steps), key=lambda row: -row["share_of_misfit"]),
        "findings": [_finding(outcome, step) for step in named(outcome)],
        "setup": [*far_parameters(outcome), *delays(outcome)],
        "unnamed": [_unnamed(outcome, step) for step in nameless(outcome)],
        "fit": _fit_figures(outcome), "rms": _rms(outcome), "upper_limits": [],
        "set_aside": dict(_set_aside(outcome)), "next_experiment": None, "model": None,
        "recordings": [
            {"file": run.name, "speed_rpm": _rpm(outcome, run), "used_for": _use(run)} for run in outcome.runs
        ],
    }  # fmt: skip


def verdict(outcome: MotionOutcome) -> str:
    """Return the contract's word for what was found."""
    if any(not is_minor(outcome, step) for step in nameless(outcome)):
        return "unexplained"
    if named(outcome):
        return "missing_physics"
    return "setup_error" if [*far_parameters(outcome), *delays(outcome)] else "adequate"


def named(outcome: MotionOutcome) -> list[Step]:
    """Return the steps whose mechanism is sure enough to be named."""
    return [step for step in outcome.steps if step.kept.hypothesis.is_named and confidence(step) >= LEAST]


def nameless(outcome: MotionOutcome) -> list[Step]:
    """Return the others, without a delay, which is a fact of the set-up."""
    sure = {id(step) for step in named(outcome)}
    return [step for step in outcome.steps if id(step) not in sure and step.kept.hypothesis.kind != "effort_delay"]


def is_minor(outcome: MotionOutcome, step: Step) -> bool:
    """Return whether a nameless effect is too small to change the verdict; the zero of a scale is no effect."""
    return step.kept.hypothesis.kind == "position_zero" or size(outcome, step.kept.hypothesis) < relevance(outcome)


def equivalent_to(step: Step) -> list[str]:
    """Return the other mechanisms that the recordings do not exclude in the place of an addition."""
    near = {other.mechanism for other, gap in step.others if gap < ALIKE and other.is_named}
    return sorted(near - {step.kept.hypothesis.mechanism})


def confidence(step: Step) -> float:
    """Return the share of the posterior mass of the class of an addition among all that was fitted in its place."""
    own = step.kept.hypothesis
    names = {own.mechanism, *equivalent_to(step)}
    total = alike = 1.0
    for other, gap in step.others:
        total += exp(-gap)
        same = other.mechanism in names if own.is_named else not other.is_named and _kind(other) == _kind(own)
        alike += exp(-gap) if same else 0.0
    return min(alike / total, MOST_SURE)


def _finding(outcome: MotionOutcome, step: Step) -> dict[str, Any]:
    own = step.kept.hypothesis
    return {
        "mechanism": own.mechanism, **({"variant": own.variant} if own.variant else {}), "part": _part(outcome, own),
        "explanation": f"The model lacks {own.label}.{_second(step)}", "confidence": round(confidence(step), 3),
        "parameters": dict(parameters_of(outcome, own)), "equivalent_to": equivalent_to(step),
        "next_experiment": None,
        "size": {"value": digits(size(outcome, own)), "unit": effort_unit(outcome.completed)},
        "alternatives": _alternatives(step),
    }  # fmt: skip


def _unnamed(outcome: MotionOutcome, step: Step) -> dict[str, Any]:
    own, rms = step.kept.hypothesis, size(outcome, step.kept.hypothesis)
    maybe = sorted({*equivalent_to(step), *([own.mechanism] if own.is_named else [])})
    names = " or ".join(name.replace("_", " ") for name in maybe)
    said = f"It may be {names}; no name is sure enough." if maybe else "No mechanism of the library explains it."
    value = amplitude(outcome, own) if own.orders else rms
    half = TWO_SIDED * _relative_error(outcome, own)
    return {
        "kind": _kind(own), "axis": own.axis or "position", "at": digits(own.at),
        "harmonics": [max(1, round(order / own.orders[0])) for order in own.orders],
        "acts_as": f"effort at {_part(outcome, own)}",
        "size": {"value": digits(value), "ci95": [digits(value * (1 - half)), digits(value * (1 + half))],
                 "unit": effort_unit(outcome.completed)},
        "in_model": own.written is not None, "minor": is_minor(outcome, step), "confidence": round(confidence(step), 3),
        "equivalent_to": maybe, "explanation": f"The recordings show {own.label}. {said}",
        "alternatives": _alternatives(step),
    }  # fmt: skip


def _relative_error(outcome: MotionOutcome, own: Hypothesis) -> float:
    """Return the standard deviation of the size over the size, from the Wald statistic of its parameters."""
    rows = [row for row, name in enumerate(outcome.fit.names) if name.startswith(f"{own.name}[")]
    if not rows:
        return 0.0
    sizes, covariance = outcome.fit.positions[rows], outcome.fit.covariance[np.ix_(rows, rows)]
    return min(1.0, float(np.sqrt(sizes @ covariance @ sizes)) / max(float(sizes @ sizes), 1e-300))


def _alternatives(step: Step) -> list[dict[str, Any]]:
    return [
        {"hypothesis": other.label, "mechanism": other.mechanism or None, "nats_behind": digits(gap)}
        for other, gap in step.others[:12]
    ]


def _second(step: Step) -> str:
    if not step.others:
        return ""
    other, gap = step.others[0]
    return f" The next best hypothesis, {other.label}, is {gap:.0f} nats less likely."


def _place(outcome: MotionOutcome, step: Step) -> dict[str, Any]:
    """Return where the calibrated model differs: the place of an addition and its share of the residual."""
    own = step.kept.hypothesis
    run = max((one for one in outcome.runs if one.seen.any()), key=lambda one: one.effort.size)
    axis = {
        "time": "s",
        "speed": _speed_unit(outcome),
        "position": _position_unit(outcome),
        "": _position_unit(outcome),
    }
    left = max(_fitted_rms(outcome), 1e-300)
    return {
        "domain": _DOMAINS[own.axis], "axis": axis.get(own.axis, own.axis), "at": digits(own.at),
        "width": digits(_width(run, own)), "recordings": [one.name for one in outcome.runs if one.seen.any()],
        "excess_dB": digits(10 * log10(1 + (size(outcome, own) / left) ** 2)),
        "share_of_misfit": digits(min(1.0, size(outcome, own) ** 2 / (size(outcome, own) ** 2 + left**2))),
        "p_value": digits(exp(-min(step.gain, 600.0))),
    }  # fmt: skip


def _width(run: ImposedRun, own: Hypothesis) -> float:
    if own.axis == "motor_shaft":
        return 2 * pi / float(np.ptp(run.position))
    if own.axis == "cycles/m":
        return 1 / float(np.ptp(run.position))
    return 1 / float(run.time[-1]) if own.axis == "Hz" else 0.0


def _fitted_rms(outcome: MotionOutcome) -> float:
    from torquerig.inference.motion.hypotheses.shown import residual_scale

    return residual_scale(outcome.fit)


def _fit_figures(outcome: MotionOutcome) -> dict[str, Any]:
    effort = max(held_out_effort(outcome), 1e-300)
    raw, old, new = (held_out_rms(outcome, one) / effort for one in outcome.held)
    return {
        "metric": METRIC, "before": {"heldout_misfit": digits(old), "nominal": digits(raw)},
        "after": {"heldout_misfit": digits(new)},
        "improvement": {"value": digits(1 - new / old), "ci95": _interval(outcome)} if outcome.steps else None,
    }  # fmt: skip


def _interval(outcome: MotionOutcome) -> list[float]:
    """Return the 95 % interval of the improvement by a bootstrap of frames."""
    rng, squares = np.random.default_rng(0), []
    for row in outcome.held[1].rows:
        one, two = ((each.residuals[row] ** 2).sum(axis=1) for each in outcome.held[1:])
        squares.append(np.column_stack([one, two]))
    every = np.vstack(squares)
    drawn = every[rng.integers(0, len(every), (400, len(every)))].sum(axis=1)
    gains = 1 - np.sqrt(drawn[:, 1] / np.maximum(drawn[:, 0], 1e-300))
    return [digits(float(end)) for end in np.quantile(gains, [0.025, 0.975])]


def _rms(outcome: MotionOutcome) -> dict[str, Any]:
    _, before, after = outcome.held
    return {
        "unit": effort_unit(outcome.completed), "before": digits(held_out_rms(outcome, before)),
        "after": digits(held_out_rms(outcome, after)),
        "recordings": [
            {"file": outcome.runs[row].name, "before": digits(held_out_rms(outcome, before, (row,))),
             "after": digits(held_out_rms(outcome, after, (row,)))}
            for row in after.rows
        ],
    }  # fmt: skip


def _set_aside(outcome: MotionOutcome) -> Iterator[tuple[str, str]]:
    found, done = {step.kept.hypothesis.mechanism for step in named(outcome)}, set[str]()
    rows: list[tuple[Any, float]] = sorted(outcome.refused, key=lambda one: -one[1])
    for each, gain in rows:
        if each.is_named and each.mechanism not in found | done:
            done.add(each.mechanism)
            change = "rises" if gain > 0 else "falls"
            yield (
                each.mechanism,
                (
                    f"tested: with {each.label} the log posterior odds {change} by {abs(gain):.1f} nats; a finding "
                    f"needs a rise of {LEAST_GAIN:g}, and held-out data that become more likely"
                ),
            )


def _kind(own: Hypothesis) -> str:
    return _KINDS.get(own.kind, "other")


def _part(outcome: MotionOutcome, own: Hypothesis) -> str:
    imposed = imposed_part(outcome.fit.model.nominal)
    for part in own.parts:
        for field in ("at", "gear", "after"):
            if getattr(part, field, None):
                return str(getattr(part, field))
    return "" if imposed is None else imposed.at


def _in_a_line(outcome: MotionOutcome) -> bool:
    return effort_unit(outcome.completed) == "N"


def _speed_unit(outcome: MotionOutcome) -> str:
    return "m/s" if _in_a_line(outcome) else "rad/s"


def _position_unit(outcome: MotionOutcome) -> str:
    return "m" if _in_a_line(outcome) else "rad"


def _rpm(outcome: MotionOutcome, run: ImposedRun) -> float:
    return 0.0 if _in_a_line(outcome) else digits(float(np.mean(np.abs(run.speed))) * 30 / pi)


def _use(run: ImposedRun) -> str:
    return "split" if run.seen.any() and run.held.any() else "fit" if run.seen.any() else "held_out"
