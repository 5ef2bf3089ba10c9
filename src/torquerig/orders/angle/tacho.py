"""The motor's angle from a tacho with one or more evenly spaced pulses per turn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.orders.angle.measured_angle import MotorAngle, of_ends
from torquerig.recordings.set_point import set_point_speed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording

PULSES_KEY = "tacho_pulses_per_motor_turn"
_SET_POINT_ERROR = 0.015  # [1] largest relative deviation of the speed from the set-point


def motor_angle_from_tacho(recording: Recording, *, ratio: float = 1.0) -> MotorAngle | None:
    """Return the motor's angle from the rising edges of a tacho channel, or None where the recording has none.

    Parameters
    ----------
    recording : Recording
        With a channel of quantity tacho. The sidecar's ``run`` may state the pulses per motor turn as
        ``tacho_pulses_per_motor_turn``; otherwise they are the multiple of 1 / ratio that fits the set-point.
    ratio : float
        Motor turns per output turn [1].

    Raises
    ------
    RecordingError
        With fewer than three pulses, or where the set-point does not determine the pulses per turn.

    Notes
    -----
    An edge is where the signal crosses the middle of its 5th and 95th percentile, interpolated linearly between
    samples; the signal must fall by a quarter of its height before the next edge. Between edges the angle is a
    monotone cubic, and beyond the outer edges it continues at constant speed. Changes of speed between two pulses are
    not resolved.
    """
    name = recording.find("tacho")
    if name is None:
        return None
    from scipy.interpolate import PchipInterpolator

    edges = rising_edges(recording.channels[name].values)
    if edges.size < 3:
        raise RecordingError(
            f"{recording.name}: the tacho channel {name} has {edges.size} pulses and an angle needs three; "
            "check the channel, or remove it"
        )
    pulses = _pulses_per_turn(recording, float(1 / np.diff(edges).mean()) * recording.sample_rate, ratio)
    at = np.arange(recording.samples, dtype=np.float64)
    turned = np.arange(edges.size, dtype=np.float64)
    inner = PchipInterpolator(edges, turned)(np.clip(at, edges[0], edges[-1]))
    first, last = 1 / (edges[1] - edges[0]), 1 / (edges[-1] - edges[-2])
    outer = first * np.minimum(at - edges[0], 0.0) + last * np.maximum(at - edges[-1], 0.0)
    # each of the two end edges is uncertain by the rounding to a sample: 1/sqrt(12)
    ends_sd = float(np.sqrt(1 / 6) / np.diff(edges).mean()) * 2 * np.pi / pulses
    angle = (inner + outer) * 2 * np.pi / pulses
    return of_ends(np.asarray(angle), f"from the tacho {name}, {pulses:g} pulses a motor turn", ends_sd)


def rising_edges(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the positions [samples, with fractions] where a pulse train rises through its middle, shape (edges,)."""
    if values.size < 3:
        return np.zeros(0)
    low, high = np.percentile(values, [5, 95])
    if high <= low:  # pulses shorter than a twentieth of the period
        low, high = values.min(), values.max()
    if high <= low:
        return np.zeros(0)
    middle, armed = 0.5 * (low + high), 0.5 * (low + high) - 0.25 * (high - low)
    above = np.flatnonzero((values[1:] >= middle) & (values[:-1] < middle))
    low_before = np.maximum.accumulate(np.where(values < armed, np.arange(values.size), -1))[above]
    kept = np.flatnonzero(np.diff(low_before, prepend=-1) > 0)  # one edge per pulse in spite of noise
    at = above[kept]
    return np.asarray(at + (middle - values[at]) / (values[at + 1] - values[at]))


def _pulses_per_turn(recording: Recording, frequency: float, ratio: float) -> float:
    stated = recording.run.others.get(PULSES_KEY)
    if isinstance(stated, int | float) and not isinstance(stated, bool) and stated > 0:
        return float(stated)
    remedy = f"add to the sidecar: run: {{{PULSES_KEY}: N}}, with the pulses in one turn of the motor as N"
    speed = abs(set_point_speed(recording, "pulses of a tacho")) / (2 * np.pi)
    whole, parts = round(frequency / speed), round(frequency / speed * ratio)
    for pulses in (float(whole), parts / ratio):
        if (
            pulses > 0
            and abs(frequency / speed / pulses - 1) <= _SET_POINT_ERROR
            and pulses * ratio <= 0.5 / (_SET_POINT_ERROR)
        ):
            return pulses
    raise RecordingError(
        f"{recording.name}: the pulses per turn do not follow from {frequency:.4g} pulses a second and the set-point; "
        f"{remedy}"
    )
