"""The set-point of the motor speed that the test conditions state, once and at each sample."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.recordings.channel_angle import unsmoothed_angle_of
from torquerig.recordings.tacho_edges import rising_edges, stated_pulses

_ONE_STROKE = 0.5  # [1] of the path that the ends are apart, at least: a recording of strokes to and fro has no speed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording


def set_point_speed(recording: Recording, purpose: str) -> float:
    """Return the set-point of the motor speed [rad/s]; where none is stated, the mean speed that a channel measured.

    Parameters
    ----------
    recording : Recording
        A channel of the output shaft counts where the run states the gear ratio.
    purpose : str
        What needs the speed, for the message.

    Raises
    ------
    RecordingError
        Where neither the run states a speed nor a channel measures one, or the gear ratio to that channel is unknown.
    """
    speed = recording.run.speed or _measured(recording)
    if not speed:
        raise RecordingError(f"{recording.name}: {missing_speed(recording, purpose)}")
    return speed


def missing_speed(recording: Recording, purpose: str) -> str:
    """Return why a recording has no speed of a shaft, and the remedy in the unit of its motion.

    Parameters
    ----------
    purpose : str
        What needs the speed, such as ``order lines``.
    """
    name = recording.find("position") or recording.find("velocity")
    if recording.find("force") is None and name is None:
        return (
            f"the run states no motor speed, no channel measures it, and {purpose} need one; "
            "add to the sidecar: run: {speed_rpm: N}, with the speed of the motor in rpm as N"
        )
    if name is not None and recording.run.travel_per_turn:
        return (
            f"{name} ends where it began, so that the recording has no mean velocity, and {purpose} need one; take a "
            "filter chain over the angle, such as order_lines, or a recording of one stroke"
        )
    has_motion = f"{name} measures its motion" if name else "no channel measures its motion"
    travel = (
        "state in the sidecar run: {travel_per_turn_mm: N}, with the lead of the screw, teeth times pitch of the belt, "
        "or pi times the pitch diameter of the pinion as N, or name the rig's scenario"
    )
    missing = [] if name else ["record a position or a velocity"]
    missing += [] if recording.run.travel_per_turn else [travel]
    needed = f"what is measured moves in a line, {has_motion}, and {purpose} are counted over turns"
    return f"{needed}; {', and '.join(missing)}"


def _measured(recording: Recording) -> float | None:
    """Return the mean motor speed [rad/s] by the first angle or speed channel, None where there is none."""
    ratio = recording.run.gear_ratio
    for quantity, factor in (("motor_angle", 1.0), ("angle", ratio), ("motor_speed", 1.0), ("speed", ratio)):
        name = recording.find(quantity)
        if name is None or recording.samples < 2:
            continue
        if factor is None:
            raise RecordingError(
                f"{recording.name}: the channel {name} is of the output shaft, and the run states neither speed_rpm "
                "nor gear_ratio; add one of them to run: in the sidecar"
            )
        channel = recording.channels[name]
        if "speed" in quantity:
            return float(np.nanmean(channel.in_si())) * factor
        angle = unsmoothed_angle_of(channel)
        turned = float(angle[-1] - angle[0]) / (angle.size - 1) * recording.sample_rate
        return turned * factor if np.isfinite(turned) else None
    return _by_tacho(recording) or _by_travel(recording)


def _by_travel(recording: Recording) -> float | None:
    """Return the mean motor speed [rad/s] by a position or velocity and the stated travel per turn, None without."""
    travel = recording.run.travel_per_turn
    name = recording.find("position") or recording.find("velocity")
    if name is None or not travel or recording.samples < 2:
        return None
    channel = recording.channels[name]
    moved = channel.in_si()
    velocity = np.nanmean(moved)
    if channel.quantity == "position":
        path = float(np.nansum(np.abs(np.diff(moved))))
        if abs(moved[-1] - moved[0]) < _ONE_STROKE * path:
            return None
        velocity = (moved[-1] - moved[0]) / (moved.size - 1) * recording.sample_rate
    return float(velocity) * 2 * np.pi / travel * (recording.run.gear_ratio or 1.0)


def _by_tacho(recording: Recording) -> float | None:
    """Return the mean motor speed [rad/s] by a tacho whose pulses per turn are stated, None where there is none."""
    name = recording.find("tacho")
    pulses = stated_pulses(recording.run, ratio=recording.run.gear_ratio)
    if name is None or pulses is None or recording.samples < 2:
        return None
    edges = rising_edges(recording.channels[name].values)
    if edges.size < 2:
        return None
    return float((edges.size - 1) / (edges[-1] - edges[0])) * recording.sample_rate * 2 * np.pi / pulses


def set_point_profile(recording: Recording, purpose: str) -> NDArray[np.float64]:
    """Return the set-point of the motor speed at each sample [rad/s], shape (samples,), by the run's profile.

    The stated profile is stretched over the length of the recording (``recordings/profiles``).
    """
    speed = set_point_speed(recording, purpose)
    return recording.run.speed_profile().speed(recording.time(), top=speed, duration=recording.duration)
