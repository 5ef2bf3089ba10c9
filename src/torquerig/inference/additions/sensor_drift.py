"""Sensor drift: a zero that moves during each recording."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob

NAMES = ("sensor_drift",)

_EXPONENTIAL, _LINEAR = -3.0, -3.7  # log-odds
_RELATIVE = 0.3  # of the signal's standard deviation: standard deviation of the span
_CONSTANTS = (0.1, 0.4)  # of the longest recording: prior medians of the time constant
_SPREAD = 1.0  # of its logarithm


def propose(context: Context) -> Iterator[Addition]:
    """Yield exponential drifts and a straight one, each in both directions."""
    longest = max(seen.run.recording.duration for seen in context.data.seen)
    name = free_name(context.rig, "sensor_drift")
    span = Knob(name, "span", _RELATIVE * context.signal / context.unit, factor=False)
    of_span = Reported("span_V", "span", "V")
    for share in _CONSTANTS:
        yield Addition(
            mechanism="sensor_drift", log_odds=_EXPONENTIAL, label="a zero that drifts exponentially",
            parts=(mechanisms.SensorDrift(name=name, span=0.0, time_constant=share * longest),),
            knobs=(span, Knob(name, "time_constant", _SPREAD)), starts=((0.3, 0.0), (-0.3, 0.0)),
            reported=(of_span, Reported("time_constant_s", "time_constant", "s")),
        )  # fmt: skip
    yield Addition(
        mechanism="sensor_drift", log_odds=_LINEAR, label="a zero that drifts linearly", knobs=(span,),
        parts=(mechanisms.SensorDrift(name=name, span=0.0, time_constant=None),), starts=((0.3,), (-0.3,)),
        reported=(of_span,),
    )  # fmt: skip
