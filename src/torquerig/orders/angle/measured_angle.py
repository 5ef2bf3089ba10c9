"""The motor's angle from an encoder, an angle channel or a speed channel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.recordings.channel_angle import angle_of, wrap_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Channel, Recording

SOURCES = ("motor_angle", "angle", "motor_speed", "speed")  # quantities in the order of preference
IN_A_LINE = ("position", "velocity")  # those that give an angle where the travel per turn is stated
TWO_SIDED = 1.96  # standard deviations of half a 95 % interval


@dataclass(frozen=True)
class MotorAngle:
    """The angle of the motor shaft at each sample [rad], shape (samples,), and its source in words.

    ``half_width`` is half the width of the 95 % interval of the mean speed, relative [1], and ``ends_sd`` the standard
    uncertainty of the angle between the two ends [rad]; each is nan where it is not known.
    """

    values: NDArray[np.float64]
    origin: str
    half_width: float = float("nan")
    ends_sd: float = float("nan")

    def mean_speed(self, rate: float) -> float:
        """Return the mean motor speed [rad/s] at ``rate`` samples per second."""
        if self.values.size < 2:
            raise RecordingError("a speed needs at least two samples; take a longer recording")
        return float((self.values[-1] - self.values[0]) / (self.values.size - 1) * rate)


def measured_motor_angle(recording: Recording, *, ratio: float = 1.0) -> MotorAngle | None:
    """Return the motor's angle from an angle or speed channel, or None where the recording has none.

    Parameters
    ----------
    recording : Recording
        Channels of quantity motor_angle, angle, motor_speed and speed are used, in this order; then position and
        velocity, where the run states the travel per turn.
    ratio : float
        Motor turns per output turn [1]; angle and speed channels belong to the output shaft, and so does a travel.

    Notes
    -----
    An angle is unwrapped where it starts again; ``origin`` states the range. Counts are smoothed over about 16 counts,
    at most 2 ms.
    """
    for quantity in SOURCES:
        name = recording.find(quantity)
        if name is not None:
            channel = recording.channels[name]
            factor = ratio if quantity in ("angle", "speed") else 1.0
            angle = angle_by(channel, recording.sample_rate, factor=factor)
            return of_ends(angle, f"from the channel {name}{_wrapping(channel)}", _rounding(channel, factor))
    return _by_travel(recording, ratio)


def has_motion(recording: Recording) -> bool:
    """Return whether a channel gives the motor's angle: of angle, speed or tacho, or of a travel per stated turn."""
    travels = IN_A_LINE if recording.run.travel_per_turn else ()
    return any(recording.find(quantity) for quantity in (*SOURCES, "tacho", *travels))


def _by_travel(recording: Recording, ratio: float) -> MotorAngle | None:
    """Return the motor's angle from the position or velocity of what a screw, rack or belt moves."""
    travel = recording.run.travel_per_turn
    for quantity in IN_A_LINE if travel else ():
        name = recording.find(quantity)
        if name is not None and travel:
            channel = recording.channels[name]
            factor = 2 * np.pi / travel * ratio
            moved = channel.in_si() if quantity == "position" else _integral_of(channel, recording.sample_rate)
            origin = f"from the channel {name}, {1e3 * travel:.6g} mm per turn"
            return of_ends(moved * factor, origin, _rounding(channel, factor))
    return None


def angle_by(channel: Channel, rate: float, *, factor: float) -> NDArray[np.float64]:
    """Return the motor's angle [rad] by an angle or speed channel whose shaft turns ``factor`` times slower."""
    read = angle_of if "angle" in channel.quantity else _integral_of
    return read(channel, rate) * factor


def _wrapping(channel: Channel) -> str:
    wrap = wrap_of(channel) if "angle" in channel.quantity else None
    return "" if wrap is None else f", which wraps at {wrap:.6g} {channel.unit}{'s' * (channel.unit == 'count')}"


def of_ends(angle: NDArray[np.float64], origin: str, ends_sd: float) -> MotorAngle:
    """Return the angle [rad], with the interval of its mean speed that ``ends_sd`` [rad] gives."""
    turned = abs(float(angle[-1] - angle[0])) if angle.size else 0.0
    return MotorAngle(angle, origin, TWO_SIDED * ends_sd / turned if turned else float("nan"), ends_sd)


def _rounding(channel: Channel, factor: float) -> float:
    """Return the uncertainty of the angle between the ends [rad] by counts: 1/sqrt(12) of a count at both."""
    return channel.si_per_unit * factor / float(np.sqrt(6)) if channel.unit == "count" else float("nan")


def _integral_of(channel: Channel, rate: float) -> NDArray[np.float64]:
    speed = channel.in_si()
    steps = 0.5 * (speed[1:] + speed[:-1]) / rate
    return np.concatenate([[0.0], np.cumsum(steps)])
