"""Adaptive cancelling of lines (LMS) with references that follow the motor's angle; causal."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.orders.analysis.order_envelope import resolved_orders
from torquerig.orders.angle.tacho import recorded_motor_angle
from torquerig.orders.line_sums.sums import adaptively_cancelled
from torquerig.recordings.set_point import set_point_profile, set_point_speed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class AdaptiveCanceller:
    """Least mean squares with a cosine and a sine per line as references: a notch that follows the angle.

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to remove. The angle is that of an encoder, speed or tacho channel, else of the set-point; an angle
        estimated from the torque is not causal.
    half_width : float
        Half the width of each notch at -3 dB [Hz], > 0; it adapts to a line within 1 / (2 pi half_width).

    Notes
    -----
    Source: Widrow et al. 1975, Proc. IEEE 63(12), 1692-1716, section on notches: a step mu
    gives a notch of half-width mu rate / (4 pi) and a time constant of 2 / mu samples. The output depends on later
    samples only through the smoothing of a counter (2 ms at most). Slow load is delayed by :meth:`delay`.
    """

    lines: tuple[KinematicLine, ...]
    half_width: float = 0.25

    def __post_init__(self) -> None:
        if not self.half_width > 0:
            raise InputError(f"an adaptive notch of half-width {self.half_width} Hz does not adapt; write above 0 Hz")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the lines; RecordingError where no speed is known."""
        if not self.lines:
            return recording
        name = recording.torque_name()
        values = recording.channels[name].values
        turns = _turned(recording, self.lines[0].output_order / self.lines[0].motor_order) / (2 * pi)
        fastest = float(np.abs(np.diff(turns)).max(initial=0.0))
        orders = resolved_orders([line.motor_order for line in self.lines], fastest)
        if not values.size:
            return recording
        first = values[0]  # subtracted, because a step at the start would ring
        step = 4 * pi * self.half_width / recording.sample_rate
        if step * orders.size >= 1:
            raise RecordingError(
                f"{recording.name}: {orders.size} adaptive notches of half-width {self.half_width:g} Hz are unstable "
                f"at {recording.sample_rate:g} Hz; make them narrower"
            )
        return recording.with_values(name, adaptively_cancelled(values - first, turns, orders, step) + first)

    def delay(self, recording: Recording) -> float:
        """Return the delay of slow load [s]: 2 half_width / (2 pi f^2) of each line, for narrow notches."""
        speed = set_point_speed(recording, "adaptive notches")
        frequencies = {line.frequency(speed) for line in self.lines}
        return sum(2 * self.half_width / (2 * pi * frequency**2) for frequency in frequencies)

    def reach(self, head: Recording) -> float:
        """Return the length of the impulse response [s]."""
        return min(14.0 / (2 * pi * self.half_width), max(head.duration, 1.0))


def _turned(recording: Recording, ratio: float) -> NDArray[np.float64]:
    angle = recorded_motor_angle(recording, ratio=ratio)
    if angle is not None:
        return angle.values
    return np.cumsum(set_point_profile(recording, "adaptive notches")) / recording.sample_rate
