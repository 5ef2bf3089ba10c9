"""The parameters that identify each mechanism, in the contract's names and units, with their 95 % intervals."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import exp, hypot, pi
from typing import Any

import numpy as np

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.outcome import Stated
from torquerig.scenario.kinematics import turns_to

_95 = 1.96
_ORDER_WIDTH = 0.01  # [1/rev] an order is known to a small part of what a recording resolves
_ARCMIN = 60 * 180 / pi
# [1] by which a line's size errs where the rig's laws are not the model's: as each ``law``, of 300 blind rigs (seeds
# 113 to 115)
_OF_A_LINE = 0.03
_SLIDING, _BREAKAWAY, _STRIBECK = 0.03, 0.5, 0.8  # what falls within a few rad/s of standstill a run passes in no time


@dataclass(frozen=True)
class _Field:
    """Where a contract parameter stands in a part: field, entry, factor to the contract's unit, relative spread.

    ``spread`` is what it is known to where no fit tells; ``law`` comes to what a fit tells, by which the same number
    errs where the rig's laws (friction near standstill, contacts, the load's pulses) are not the model's.
    """

    field: str
    unit: str
    factor: float = 1.0
    key: int | None = None
    whole_order: bool = False
    spread: float = 0.0
    law: float = 0.0


_FIELDS: Mapping[str, Mapping[str, _Field]] = {
    "gear_mesh": {
        "order_output": _Field("order_output", "1/rev", whole_order=True),
        "transmission_error_rad": _Field("transmission_error", "rad", key=0),
    },
    "commutation_ripple": {
        "order_motor": _Field("order_motor", "1/rev", whole_order=True),
        "depth": _Field("depth", "1"),
    },
    "torsional_mode": {
        "frequency_Hz": _Field("frequency", "Hz", law=0.01),
        "inertia_kgm2": _Field("inertia", "kg m^2", law=0.1),
        "damping_ratio": _Field("damping_ratio", "1"),
    },
    "backlash": {"gap_arcmin": _Field("gap", "arcmin", factor=_ARCMIN, spread=0.3)},
    "bearing_defect": {
        "order_output": _Field("order_output", "1/rev", whole_order=True),
        "ring_frequency_Hz": _Field("ring_frequency", "Hz", law=0.005),
    },
    "mains_interference": {
        "frequency_Hz": _Field("frequency", "Hz", spread=2e-4),
        "amplitude_V": _Field("amplitudes", "V", key=0),
    },
    "sensor_bandwidth": {"cutoff_Hz": _Field("cutoff", "Hz", law=0.05)},
    "sensor_drift": {"span_V": _Field("span", "V"), "time_constant_s": _Field("time_constant", "s")},
    "clipping": {"limit_V": _Field("limit", "V", spread=2e-4)},
    "quantization": {"step_V": _Field("step", "V", spread=1e-4)},
    "pwm_aliasing": {"frequency_Hz": _Field("frequency", "Hz", spread=1e-5), "amplitude_V": _Field("amplitude", "V")},
    "blade_pass": {
        "order_output": _Field("order_output", "1/rev", whole_order=True),
        "amplitude_Nm": _Field("amplitude", "N m", law=_OF_A_LINE),
    },
    "quadratic_drag": {"coefficient_Nms2": _Field("coefficient", "N m s^2/rad^2")},
    "signal_dropout": {
        "duration_ms": _Field("duration", "ms", factor=1e3, spread=0.03),
        "rate_per_minute": _Field("rate", "1/min", factor=60.0, spread=0.2),
    },
}  # fmt: skip


def identifying(candidate: Candidate, model: Calibrated, case: Case) -> dict[str, Stated]:
    """Return the contract's parameters of an effect in the fitted model."""
    part = model.rig.part(candidate.parts[0].name)
    special: dict[str, Callable[[Any, Calibrated, Case], dict[str, Stated]]] = {
        "stribeck_friction": _friction,
        "cogging": _cogging,
    }
    if candidate.mechanism in special:
        return special[candidate.mechanism](part, model, case)
    answer = {}
    for name, field in _FIELDS[candidate.mechanism].items():
        held = getattr(part, field.field)
        value = held if field.key is None or held is None else held[field.key]
        if value is None:
            continue
        stated = _stated(model, part.name, field, float(value) * field.factor)
        low, high = candidate.within.get(field.field, (None, None))
        if low is not None and high is not None:
            stated = replace(stated, low=low * field.factor, high=high * field.factor)
        answer[name] = stated
    if candidate.mechanism == "gear_mesh":
        read = _at_sensor(part, case)
        answer |= {} if read is None else {"amplitude_Nm": read}
    return answer


def _stated(model: Calibrated, part: str, field: _Field, value: float) -> Stated:
    if field.whole_order:
        return Stated(value=value, low=value - _ORDER_WIDTH, high=value + _ORDER_WIDTH, unit=field.unit)
    for index, knob in enumerate(model.knobs):
        if (knob.part, knob.field, knob.key) == (part, field.field, field.key):
            sigma = float(np.sqrt(max(model.covariance[index, index], 0.0))) * knob.spread
            if knob.factor:
                sigma = hypot(sigma, field.law)
                return Stated(
                    value=value, low=value * exp(-_95 * sigma), high=value * exp(_95 * sigma), unit=field.unit
                )
            reach = _95 * hypot(sigma * field.factor, field.law * value)
            return Stated(value=value, low=value - reach, high=value + reach, unit=field.unit)
    reach = _95 * field.spread * abs(value)
    return Stated(value=value, low=value - reach, high=value + reach, unit=field.unit)


def _friction(part: Any, model: Calibrated, case: Case) -> dict[str, Stated]:
    names = {
        "coulomb_Nm": _Field("coulomb", "N m", law=_SLIDING),
        "static_Nm": _Field("static", "N m", law=_BREAKAWAY),
        "stribeck_rad_s": _Field("stribeck_speed", "rad/s", law=_STRIBECK),
    }
    answer = {}
    for name, field in names.items():
        backward = getattr(part, f"{field.field}_backward", None)
        forward = _stated(model, part.name, field, getattr(part, field.field))
        if backward is None:
            answer[name] = forward
        else:
            answer[f"{name}_forward"] = forward
            opposite = replace(field, field=f"{field.field}_backward")
            answer[f"{name}_backward"] = _stated(model, part.name, opposite, backward)
    return answer


def _cogging(part: Any, model: Calibrated, case: Case) -> dict[str, Stated]:
    sizes = part.amplitudes()
    largest = max(sizes, key=lambda at: sizes[at])
    name, key = part.held_by(largest)
    field = _Field(name, "N m", key=key)
    return {
        "order_motor": Stated(value=largest, low=largest - _ORDER_WIDTH, high=largest + _ORDER_WIDTH, unit="1/rev"),
        "amplitude_Nm": _stated(model, part.name, field, sizes[largest]),
    }


def _at_sensor(part: Any, case: Case) -> Stated | None:
    """Amplitude of the first tooth harmonic at the sensor [N m], in the steady run that reads most of it, if any."""
    turns = turns_to(case.nominal, part.gear)
    read = [_line_read(features, part.order_output / turns) for features in case.seen if features.observed.steady]
    shown = [each for each in read if each is not None]
    return max(shown, key=lambda each: each.value, default=None)


def _line_read(features: Features, at: float) -> Stated | None:
    near = [i for i, other in enumerate(features.places) if other.domain == "order" and abs(other.at - at) < 0.01]
    sizes = np.abs(features.amplitude[:, near[0]]) if near and features.amplitude.size else np.zeros(0)
    sizes = sizes[np.isfinite(sizes)]
    if not sizes.size:
        return None
    mean = float(np.sqrt((sizes**2).mean()))
    reach = _95 * hypot(float(sizes.std() / np.sqrt(sizes.size)), _OF_A_LINE * mean)
    return Stated(value=mean, low=max(mean - reach, 0.0), high=mean + reach, unit="N m")
