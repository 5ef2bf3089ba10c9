"""A nameless course: zero or gain of the reading change during each recording, whatever the cause."""

from __future__ import annotations

from collections.abc import Iterator
from math import log

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import Addition, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.inference.mean_torques import MeanTorques
from torquerig.sensor_stages.course import Course, Shape

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
    torques = MeanTorques.of(context)
    unit = {"zero": _ZERO * context.signal / context.unit, "gain": _GAIN}
    for field, shapes in _SHAPES.items():
        for shape in shapes:
            for gain, size, at in _ranked(torques, shape, field)[:_BEST]:
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


def _ranked(torques: MeanTorques, shape: Shape, field: str) -> list[tuple[float, float, float]]:
    """Return gain [nats], size [N m] or [1] and moment of the courses of a shape, the best first."""
    moments = _moments(shape)
    if not torques.rest.size:
        return []
    unit = torques.sign if field == "zero" else torques.expected
    courses = [unit * Course(shape=shape, at=at).mean(torques.low, torques.high) for at in moments]
    gains, sizes = torques.explained(np.stack(courses, axis=1))
    return sorted(zip(gains.tolist(), sizes.tolist(), moments, strict=True), reverse=True)
