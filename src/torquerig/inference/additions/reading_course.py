"""A nameless course: zero or gain of the reading change during each recording, whatever the cause."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import log

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.inference.addition import Addition, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.sensor_stages.course import Course, Shape

Floats = NDArray[np.float64]

_LOG_ODDS = -3.0  # of a course of zero or gain, whatever its shape and moment; as of a drift of the sensor
_STEPS = 24  # moments of a recording that are compared: a moment is then within 2 % of its length
_MOMENT = 1.0 / _STEPS  # [1] standard deviation of the moment about one of them
_CONSTANTS, _CONSTANT = (0.1, 0.3, 1.0), 0.6  # of a settling: shares of a recording, spread of the logarithm
_ZERO, _GAIN = 0.3, 0.2  # of the signal's standard deviation, and [1]: standard deviations of the changes
_BEST = 4  # moments of each shape that are proposed
_SHAPES: dict[str, tuple[Shape, ...]] = {"zero": ("step", "ramp"), "gain": ("step", "ramp", "settling")}
_KINDS = {"zero": "level_course", "gain": "gain_course"}
_MOST = 3.0  # [standard deviations] at which a fit begins at most


def propose(context: Context) -> Iterator[Addition]:
    """Yield steps, ramps and settlings, each at the moments at which it explains most of the mean torques."""
    levels = _Levels.of(context)
    unit = {"zero": _ZERO * context.signal / context.unit, "gain": _GAIN}
    for field, shapes in _SHAPES.items():
        for shape in shapes:
            ranked = sorted(((*levels.explained(shape, at, field), at) for at in _moments(shape)), reverse=True)
            for gain, size, at in ranked[:_BEST] if levels.rest.size else ():
                if gain > 0:
                    yield _course(context, field, shape, at=at, size=size, unit=unit[field])


def _course(context: Context, field: str, shape: Shape, *, at: float, size: float, unit: float) -> Addition:
    name, settles = free_name(context.rig, "unnamed_course"), shape == "settling"
    moment = Knob(name, "at", _CONSTANT) if settles else Knob(name, "at", _MOMENT, factor=False)
    longest = max(seen.run.recording.duration for seen in context.data.seen)
    when = "that settles within" if settles else "that steps after" if shape == "step" else "that moves after"
    start = float(np.clip(size / (context.unit if field == "zero" else 1.0) / unit, -_MOST, _MOST))
    return Addition(
        kind=_KINDS[field], parts=(mechanisms.ReadingCourse(name=name, shape=shape, at=at),),
        knobs=(Knob(name, field, unit, factor=False), moment), starts=((start, 0.0),),
        log_odds=_LOG_ODDS - log(len(_moments(shape)) * sum(map(len, _SHAPES.values()))),
        label=f"a {field} {when} {at * longest:.3g} s",
    )  # fmt: skip


def _moments(shape: Shape) -> tuple[float, ...]:
    return _CONSTANTS if shape == "settling" else tuple(step / _STEPS for step in range(1, _STEPS))


@dataclass(frozen=True)
class _Levels:
    """Mean torques of all runs: shares of the recording between which they are, residuals, expected ones, weights."""

    low: Floats
    high: Floats
    rest: Floats
    expected: Floats
    weight: Floats
    sign: Floats

    @staticmethod
    def of(context: Context) -> _Levels:
        rows = []
        for seen, model in zip(context.data.seen, context.fit.expected, strict=True):
            off = context.fit.off
            largest = float(np.abs(seen.level).max(initial=0.0))
            variance = np.diag(model.level_covariance) + (off.level_floor * largest) ** 2
            variance = variance + (off.level * model.level) ** 2 + (model.level_rate * seen.level_time_error) ** 2
            shares = seen.parts / seen.run.torque.size
            rows.append((shares[:, 0], shares[:, 1], seen.level - model.level, model.level,
                         1 / np.maximum(variance, 1e-300), np.full(seen.level.size, np.sign(seen.unit))))  # fmt: skip
        return _Levels(*(np.concatenate(columns) for columns in zip(*rows, strict=True)))

    def explained(self, shape: Shape, at: float, field: str) -> tuple[float, float]:
        """Return by how much a course lowers the weighted sum of squares, and its size [N m] or [1].

        A constant zero and a constant scale are taken out of both before.
        """
        course = Course(shape=shape, at=at).mean(self.low, self.high)
        column = course * (self.sign if field == "zero" else self.expected)
        root = np.sqrt(self.weight)
        known, _ = np.linalg.qr(np.stack([root, root * self.expected], axis=1))
        column, rest = root * column, root * self.rest
        column, rest = column - known @ (known.T @ column), rest - known @ (known.T @ rest)
        square = float(column @ column)
        if square <= 1e-12 * float(np.square(root * course).sum()):
            return 0.0, 0.0
        along = float(column @ rest)
        return along**2 / square, along / square
