"""Mean of the torque over whole turns of the output shaft, which removes every line of the shaft."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

from torquerig.errors import InputError, RecordingError
from torquerig.filters.moving_mean import moving_mean
from torquerig.orders.angle.tacho import recorded_motor_angle
from torquerig.recordings.set_point import set_point_speed

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class RevolutionMean:
    """The centred mean over ``turns`` turns of the output shaft at the run's mean speed, over fewer at the ends.

    Parameters
    ----------
    ratio : float
        Motor turns per output turn [1], > 0.
    turns : float
        Turns of the output shaft, > 0; a whole number removes every whole output order.

    Notes
    -----
    The mean speed is that of an angle or speed channel, else the set-point. Gain sin(pi n turns) / (pi n turns) at
    output order n: load faster than about half a turn is removed too. For a steady speed; in a ramp the zeros do not
    match the lines.
    """

    ratio: float
    turns: float = 1.0

    def __post_init__(self) -> None:
        if not self.turns > 0 or not self.ratio > 0:
            raise InputError(
                f"a mean over {self.turns} turns at a ratio of {self.ratio} is not possible; both must be above 0"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque averaged; RecordingError where it is shorter than the window."""
        angle = recorded_motor_angle(recording, ratio=self.ratio)
        rate = recording.sample_rate
        speed = set_point_speed(recording, "means over turns") if angle is None else angle.mean_speed(rate)
        window = round(self.turns * self.ratio * 2 * pi / abs(speed) * rate) if speed else recording.samples + 1
        if window > recording.samples:
            raise RecordingError(
                f"{recording.name}: the shaft turns fewer than {self.turns:g} times in {recording.duration:.3g} s; "
                "take a longer recording or fewer turns"
            )
        name = recording.torque_name()
        return recording.with_values(name, moving_mean(recording.channels[name].values, max(window, 1)))
