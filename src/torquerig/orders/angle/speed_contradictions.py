"""Sentences on angle and speed channels that contradict the set-point or each other, with the likely reason."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.angle.measured_angle import SOURCES, angle_by
from torquerig.orders.angle.speed_posterior import REACH
from torquerig.recordings.channel_angle import wrap_of
from torquerig.recordings.set_point import set_point_profile
from torquerig.units import UNITS

if TYPE_CHECKING:
    from torquerig.recordings.recording import Channel, Recording

_SAME = 0.02  # [1] two speeds further apart contradict each other; a ratio is recognised within it
_RATE_ERROR = 0.2  # [1] a deviation below it may be that of the sample rate or the set-point
_MISCOUNTED = (2.0, 4.0, 0.5, 0.25)  # edges counted per line of an encoder, wrongly taken or left out
_EACH = 3  # channels with which each further one is compared
_SAMPLES_PER_TURN = 10  # below it a run at a multiple of the speed is as plausible as the slow one
_COMPARED = ("steady", "ramp")
_RPM = 30 / np.pi


@dataclass(frozen=True)
class _Measured:
    """The mean motor speed [rad/s] by one channel; ``is_output`` where the sidecar states the output shaft."""

    name: str
    channel: Channel
    is_output: bool
    speed: float


def speed_contradictions(recording: Recording, *, ratio: float | None = None) -> tuple[str, ...]:
    """Return one sentence per angle or speed channel that contradicts the set-point or another channel.

    Parameters
    ----------
    recording : Recording
        Samples that are no numbers must be cut off.
    ratio : float, optional
        Motor turns per output turn [1]; by default that of the run.

    Notes
    -----
    Contradictions are mean speeds more than 1.5 % from the set-point of a steady run or a ramp, and channels more than
    2 % apart. The reasons that are recognised: the other shaft, counts per turn, the unit, the sample rate.
    """
    ratio = ratio or recording.run.gear_ratio or 1.0
    measured = _measured(recording, ratio)
    stated = _stated(recording)
    folded = [sentence for one in measured for sentence in _folded(one, recording.sample_rate, ratio)]
    found: list[str] = []
    if stated:
        found = [_against_set_point(one, stated, ratio) for one in measured if _apart(one.speed, stated) > REACH]
    if not found:
        # of many channels each is compared with the first
        pairs = [(one, other) for at, one in enumerate(measured) for other in measured[: min(at, _EACH)]]
        found = [_against_each_other(*pair, ratio) for pair in pairs if _apart(pair[0].speed, pair[1].speed) > _SAME]
    return (*folded, *found)


def _folded(one: _Measured, rate: float, ratio: float) -> list[str]:
    """Return a sentence for an angle that wraps and has so few samples a turn that whole turns may be missing."""
    if "angle" not in one.channel.quantity or wrap_of(one.channel) is None:
        return []
    turns = one.speed / (2 * np.pi * rate) / (ratio if one.is_output else 1.0)
    if turns < 1 / _SAMPLES_PER_TURN:
        return []
    sentence = (
        f"{one.name} wraps and has only {1 / turns:.3g} samples a turn; a shaft that turns further by whole turns from "
        "sample to sample would look the same, so check its speed by another source"
    )
    return [sentence]


def _measured(recording: Recording, ratio: float) -> list[_Measured]:
    found = []
    for quantity in SOURCES:
        for name, channel in recording.channels.items():
            if channel.quantity != quantity or channel.truth or channel.values.size < 2:
                continue
            is_output = quantity in ("angle", "speed")
            angle = angle_by(channel, recording.sample_rate, factor=ratio if is_output else 1.0)
            speed = abs(float(angle[-1] - angle[0])) / (angle.size - 1) * recording.sample_rate
            found.append(_Measured(name, channel, is_output, speed))
    return [one for one in found if np.isfinite(one.speed) and one.speed > 0]


def _stated(recording: Recording) -> float | None:
    run = recording.run
    if not run.speed or run.profile not in _COMPARED or recording.samples < 2:
        return None
    return float(np.abs(set_point_profile(recording, "a comparison")).mean())


def _apart(speed: float, other: float) -> float:
    return abs(speed / other - 1)


def _against_set_point(one: _Measured, stated: float, ratio: float) -> str:
    times = one.speed / stated
    reasons = " or ".join(_reasons(one, times, ratio)) or "check its unit, its counts per turn and speed_rpm"
    return (
        f"{one.name} says {one.speed * _RPM:.5g} rpm of the motor, {times:.4g} times the set-point of "
        f"{stated * _RPM:.5g} rpm: {reasons}"
    )


def _against_each_other(one: _Measured, other: _Measured, ratio: float) -> str:
    times = one.speed / other.speed
    reasons = [f"{one.name}: {each}" for each in _reasons(one, times, ratio, alone=False)]
    reasons += [f"{other.name}: {each}" for each in _reasons(other, 1 / times, ratio, alone=False)]
    return (
        f"{one.name} says {one.speed * _RPM:.5g} rpm of the motor and {other.name} {other.speed * _RPM:.5g} rpm, "
        f"{times:.4g} times as much: {' or '.join(reasons) or 'check their units and counts per turn, and gear_ratio'}"
    )


def _reasons(one: _Measured, times: float, ratio: float, *, alone: bool = True) -> list[str]:
    """Return what would explain that a channel says ``times`` the right speed, as questions."""
    reasons = []
    wrong_shaft = ratio if one.is_output else 1 / ratio
    if _apart(ratio, 1.0) > _SAME and _apart(times, wrong_shaft) < _SAME:
        reasons.append(f"is it of the {'motor' if one.is_output else 'output'} shaft?")
    if one.channel.unit == "count":
        turn = 2 * np.pi / one.channel.si_per_unit
        reasons += [f"{turn * each:.6g} counts per turn?" for each in _MISCOUNTED if _apart(times, each) < _SAME]
    else:
        kind = "angle" if "angle" in one.channel.quantity else "speed"
        factors = {factor: unit for unit, factor in reversed(UNITS[kind].items())}
        reasons += [
            f"is it in {unit}?"
            for factor, unit in factors.items()
            if _apart(one.channel.si_per_unit / factor, 1.0) > _SAME
            and _apart(times, one.channel.si_per_unit / factor) < _SAME
        ]
    if alone and not reasons and _apart(times, 1.0) < _RATE_ERROR:
        is_angle = "angle" in one.channel.quantity
        reasons.append("check sample_rate_Hz and speed_rpm" if is_angle else "check speed_rpm and the channel's scale")
    return reasons
