"""Sensor drift: a zero that moves during each recording."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.inference.mean_torques import MeanTorques
from torquerig.sensor_stages.drift import Drift

NAMES = ("sensor_drift",)

_EXPONENTIAL, _LINEAR = -3.0, -3.7  # log-odds
_RELATIVE = 0.3  # of the signal's standard deviation: standard deviation of the span
_CONSTANTS = (0.1, 0.4)  # of the longest recording: prior medians of the time constant
_SPREAD = 1.0  # of its logarithm
_COMPARED = (-1.0, -0.5, 0.0, 0.5, 1.0)  # [standard deviations] of it: where the span of most gain is sought
_POINTS = 4  # of a part whose mean is compared: right within 0.3 % of the span where the constant is two parts or more
_LEAST, _MOST = 0.3, 3.0  # [standard deviations] of the span at which a fit begins


def propose(context: Context) -> Iterator[Addition]:
    """Yield exponential drifts and a straight one, each from the span by which it explains most of the mean torques."""
    longest = max(seen.run.recording.duration for seen in context.data.seen)
    name, unit = free_name(context.rig, "sensor_drift"), _RELATIVE * context.signal / context.unit
    span, of_span = Knob(name, "span", unit, factor=False), Reported("span_V", "span", "V")
    torques = MeanTorques.of(context)
    for share in _CONSTANTS:
        constant = Knob(name, "time_constant", _SPREAD)
        part = mechanisms.SensorDrift(name=name, span=0.0, time_constant=share * longest)
        taus = [constant.turned(share * longest, at) for at in _COMPARED]
        best, start = _start(context, torques, taus, unit)
        yield Addition(
            mechanism="sensor_drift", log_odds=_EXPONENTIAL, label="a zero that drifts exponentially", parts=(part,),
            knobs=(span, constant), starts=((start, _COMPARED[best]),),
            reported=(of_span, Reported("time_constant_s", "time_constant", "s")),
        )  # fmt: skip
    _, start = _start(context, torques, [None], unit)
    yield Addition(
        mechanism="sensor_drift", log_odds=_LINEAR, label="a zero that drifts linearly", knobs=(span,),
        parts=(mechanisms.SensorDrift(name=name, span=0.0, time_constant=None),), starts=((start,),),
        reported=(of_span,),
    )  # fmt: skip


def _start(
    context: Context, torques: MeanTorques, taus: Sequence[float | None], unit: float
) -> tuple[int, float]:  # fmt: skip
    """Return which time constant [s] explains most (None: a straight line), and the span there in ``unit``."""
    gains, sizes = torques.explained(np.stack([_drift(context, tau) * torques.sign for tau in taus], axis=1))
    best = int(np.argmax(gains))
    start = float(sizes[best]) / context.unit / unit
    return best, float(np.copysign(np.clip(abs(start), _LEAST, _MOST), start))


def _drift(context: Context, tau: float | None) -> NDArray[np.float64]:
    """Return the mean of a drift of the span 1 in each part of all runs, shape (levels,)."""
    rows = []
    for seen in context.data.seen:
        share = seen.parts[:, :1] + (np.arange(_POINTS) + 0.5) / _POINTS * np.diff(seen.parts, axis=1)
        course = Drift(span=1.0, time_constant=tau).course(share / seen.run.rate, seen.run.recording.duration)
        rows.append(course.mean(axis=1))
    return np.concatenate(rows)
