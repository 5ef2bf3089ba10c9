"""A zero that moves while the recording runs, whatever the shafts do."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnosis.case import SLOW_TORQUE, Candidate, Case
from torquerig.diagnosis.expecting.added_signals import zero_of
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.misfit import LEVEL_FLOOR
from torquerig.diagnosis.hypotheses.beside_steps import price_beside_steps
from torquerig.inference.knobs import Knob
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Part

_CONSTANTS = (0.03, 0.06, 0.12, 0.25, 0.5, 1.0)  # of the longest recording
_START = 0.15  # [V] where the levels tell no span
_SPREAD = 0.3  # [V]
_FASTEST = 0.25  # [s] heat and creep take longer to move a zero; what has settled sooner is an offset from the start


def propose(case: Case) -> Iterator[Candidate]:
    """Yield the exponential and the straight drift that explain most of how the levels stray within the runs.

    What all parts of a run share is left to the level of its load, and what goes with the speed to viscous friction:
    both have taken their part of a drift, as the load's slow variation has.
    """
    longest = max(run.recording.duration for run in case.runs)
    price = price_beside_steps(case)
    for variant, constants in (("exponential", [share * longest for share in _CONSTANTS]), ("linear", [None])):
        fits = [_span(case, constant) for constant in constants]
        span, _ = fits[best := int(np.argmax([explained for _, explained in fits]))]
        for sign in (1.0,) if span else (1.0, -1.0):
            part = mechanisms.SensorDrift(
                name="sensor_drift", span=span or sign * _START, time_constant=constants[best]
            )  # fmt: skip
            knobs = [Knob(part.name, "span", max(_SPREAD, 0.3 * abs(part.span)), factor=False)]
            knobs += [] if part.time_constant is None else [Knob(part.name, "time_constant", 0.7)]
            yield Candidate(
                mechanism="sensor_drift", parts=(part,), knobs=tuple(knobs), variant=variant, loosens=SLOW_TORQUE,
                slow=True, price=price,
            )  # fmt: skip


def _span(case: Case, constant: float | None) -> tuple[float, float]:
    """Return the span [V] of least squares over the levels' course in each run, and what it explains of its squares."""
    unit = mechanisms.SensorDrift(name="sensor_drift", span=1.0, time_constant=constant)
    strayed, moved = list[NDArray[np.float64]](), list[NDArray[np.float64]]()
    for features in case.seen:
        if features.turning is not None:
            continue
        twin = Twin((case.model.rig + unit).at(features.observed.run))
        shape = zero_of(twin, features)
        left = features.level - expected(case.model.rig, features).level
        shared = [np.ones(left.size)] if features.observed.steady else [np.ones(left.size), features.speed.mean(axis=1)]
        chance = float(np.hypot(np.std(np.diff(left)) / np.sqrt(2), LEVEL_FLOOR)) if left.size > 1 else np.inf
        for course, kept in ((left, strayed), (shape, moved)):
            kept.append(_without(course, np.column_stack(shared)) / chance)
    if not strayed:
        return 0.0, 0.0
    residual, wave = np.concatenate(strayed), np.concatenate(moved)
    power = float(wave @ wave)
    span = float(residual @ wave) / power if power > 0 else 0.0
    return span, span**2 * power


def _without(course: NDArray[np.float64], columns: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(course - columns @ np.linalg.lstsq(columns, course, rcond=None)[0])


def possible(part: Part) -> bool:
    """Whether a fitted zero moves within the recording, and does not stand elsewhere from its start."""
    if not isinstance(part, mechanisms.SensorDrift):
        return False
    return part.time_constant is None or part.time_constant > _FASTEST
