"""The motor's angle from a tacho with one or more evenly spaced pulses per turn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.orders.angle.measured_angle import MotorAngle, measured_motor_angle, of_ends
from torquerig.recordings.set_point import set_point_speed
from torquerig.recordings.tacho_edges import rising_edges, stated_pulses

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

_SET_POINT_ERROR = 0.015  # [1] largest relative deviation of the speed from the set-point


def recorded_motor_angle(recording: Recording, *, ratio: float = 1.0) -> MotorAngle | None:
    """Return the motor's angle from an angle or speed channel, else from a tacho; None where there is neither.

    Raises
    ------
    RecordingError
        For a tacho that does not give an angle (:func:`motor_angle_from_tacho`).
    """
    return measured_motor_angle(recording, ratio=ratio) or motor_angle_from_tacho(recording, ratio=ratio)


def motor_angle_from_tacho(recording: Recording, *, ratio: float = 1.0) -> MotorAngle | None:
    """Return the motor's angle from the rising edges of a tacho channel, or None where the recording has none.

    Parameters
    ----------
    recording : Recording
        With a channel of quantity tacho. The sidecar may state its pulses per turn (``pulses_per_rev`` or ``teeth``,
        and ``shaft: output`` where it is on the output shaft); otherwise they are the multiple of 1 / ratio that fits
        the set-point.
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


def _pulses_per_turn(recording: Recording, frequency: float, ratio: float) -> float:
    stated = stated_pulses(recording.run, ratio=ratio)
    if stated is not None:
        return stated
    remedy = "add to its channel in the sidecar: pulses_per_rev: N, and shaft: output where it is not on the motor"
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
