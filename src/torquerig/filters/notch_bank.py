"""Notch bank: a second-order notch at each line, zero-phase or causal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.filters.biquads import cascaded, quiet_start, slow_delay, zero_phase_notched
from torquerig.filters.counted_periods import separable_lines
from torquerig.orders.angle.best_angle import best_motor_speed
from torquerig.recordings.set_point import set_point_speed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

_HIGHEST_SHARE_OF_RATE = 0.45
_REACH = 14.0  # time constants after which ringing has decayed to e^-14, 8e-7
_WIDEST = 1 / 3  # width of a notch as a share of its frequency, at most, so that the mean is not changed


@dataclass(frozen=True, kw_only=True)
class NotchBank:
    """Notches at the lines' frequencies, applied forwards and backwards: no delay, the mean is kept.

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to remove, at the run's mean speed: from an encoder, tacho or speed channel, else from the comb of the
        lines in the torque.
    half_width : float
        Half the width of each notch at -3 dB of one pass [Hz], > 0; a notch rings for 1 / (2 pi half_width).

    Notes
    -----
    Source: Oppenheim & Schafer, Discrete-Time Signal Processing, on second-order notches and forward-backward
    filtering; edges by :func:`~torquerig.filters.biquads.zero_phase_notched`. Limits: a speed that varies by more than
    half_width / frequency, and notches wider than their spacing.
    """

    lines: tuple[KinematicLine, ...]
    half_width: float = 0.5

    def __post_init__(self) -> None:
        _check_width(self.half_width)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the lines; RecordingError where no speed is known."""
        if not self.lines:
            return recording
        speed = best_motor_speed(recording, self.lines).value
        turns = speed * recording.duration / (2 * pi)
        lines = separable_lines(self.lines, turns, name=recording.name)
        name, sections = recording.torque_name(), notches(lines, speed, self.half_width, recording.sample_rate)
        values = recording.channels[name].values
        if values.size <= 6 * len(sections) + 3:
            raise RecordingError(
                f"{recording.name}: {values.size} samples are too few for {len(sections)} notches; "
                "take a longer recording"
            )
        return recording.with_values(name, zero_phase_notched(values, sections))

    def reach(self, head: Recording) -> float:
        """Return the length of the impulse response on either side [s]."""
        return _REACH / (2 * pi * min(self.half_width, _slowest(self.lines, head)))


@dataclass(frozen=True, kw_only=True)
class CausalNotchBank:
    """Causal notches at the lines' frequencies at the set-point, as for a live display.

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to remove, at the set-point of the run, because the mean speed is known only at the end.
    half_width : float
        Half the width of each notch at -3 dB [Hz], > 0.

    Notes
    -----
    Slow load is delayed by :meth:`delay`. Load just below a line is delayed more; just above it the delay is negative.
    The time constant at the start is 1 / (2 pi half_width).
    """

    lines: tuple[KinematicLine, ...]
    half_width: float = 0.5

    def __post_init__(self) -> None:
        _check_width(self.half_width)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` notched sample by sample; RecordingError where the run states no speed."""
        if not self.lines:
            return recording
        speed = set_point_speed(recording, "the notches")
        name, sections = recording.torque_name(), notches(self.lines, speed, self.half_width, recording.sample_rate)
        values = recording.channels[name].values
        if not values.size or not len(sections):
            return recording
        # steady state for the first sample: later samples are not known to a causal filter
        states = quiet_start(values[:1], sections)
        return recording.with_values(name, cascaded(values, sections, states=states)[0])

    def reach(self, head: Recording) -> float:
        """Return the length of the impulse response [s]."""
        return _REACH / (2 * pi * min(self.half_width, _slowest(self.lines, head)))

    def delay(self, recording: Recording) -> float:
        """Return the delay of slow load [s]: the sum of the notches' group delays at 0 Hz."""
        speed = set_point_speed(recording, "the notches")
        sections = notches(self.lines, speed, self.half_width, recording.sample_rate)
        return slow_delay(sections) / recording.sample_rate


def notches(lines: Sequence[KinematicLine], motor_speed: float, half_width: float, rate: float) -> NDArray[np.float64]:
    """Return one notch per frequency, shape (notches, 6), the lowest first; lines above 0.45 of ``rate`` have none.

    Parameters
    ----------
    motor_speed : float
        [rad/s].
    half_width : float
        [Hz]; no notch is wider than a third of its frequency.
    """
    centres = sorted({float(f"{line.frequency(motor_speed):.9g}") for line in lines})
    return np.array(
        [_notch(2 * pi * at / rate, 2 * pi * min(2 * half_width, at * _WIDEST) / rate)
         for at in centres if 0 < at <= _HIGHEST_SHARE_OF_RATE * rate]
    ).reshape(-1, 6)  # fmt: skip


def _notch(centre: float, width: float) -> tuple[float, ...]:
    """Return the biquad with zeros on the unit circle at ``centre`` and -3 dB at ``width`` [rad/sample]."""
    gain = 1 / (1 + np.tan(width / 2))
    middle = -2 * gain * np.cos(centre)
    return float(gain), float(middle), float(gain), 1.0, float(middle), float(2 * gain - 1)


def _slowest(lines: Sequence[KinematicLine], recording: Recording) -> float:
    """Return half the width of the widest notch that the lowest line may have [Hz]."""
    speed = set_point_speed(recording, "the notches")
    return min((0.5 * _WIDEST * line.frequency(speed) for line in lines), default=float("inf"))


def _check_width(half_width: float) -> None:
    if not half_width > 0:
        raise InputError(f"notches of half-width {half_width} Hz remove nothing; write more than 0 Hz")
