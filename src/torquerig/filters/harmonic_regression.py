"""Harmonic regression: least-squares sines of the known lines over the motor's angle, subtracted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError
from torquerig.filters.counted_periods import separable_lines
from torquerig.orders.analysis.line_fit import fitted_lines
from torquerig.orders.angle.best_angle import best_motor_angle

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class HarmonicRegression:
    """Subtracts the least-squares sines of ``lines`` from the torque; the mean is kept.

    The angle is the recording's best one (:func:`~torquerig.orders.angle.best_angle.best_motor_angle`).

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to subtract.
    block : float
        Length over which a line's amplitude and phase are constant [s], > 0; blocks overlap by half, and a shorter
        recording is one block.

    Notes
    -----
    Source: handbook 0 (order-locked lines need order tracking; Fyfe & Munck 1997). Limits: load within about 1 / block
    of a line is subtracted with it; an amplitude that changes faster than a block is followed only in part; without an
    encoder, changes of the angle within some tenths of a second are not followed.
    """

    lines: tuple[KinematicLine, ...]
    block: float = 4.0

    def __post_init__(self) -> None:
        if not self.block > 0:
            raise InputError(f"blocks of {self.block} s cannot be fitted; write for example 4 s")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the lines; RecordingError where it is too short or has no angle."""
        if not self.lines:
            return recording
        name = recording.torque_name()
        values, rate = recording.channels[name].values, recording.sample_rate
        angle = best_motor_angle(recording, self.lines)
        turns = float(np.abs(np.diff(angle.values)).sum() / (2 * np.pi))
        orders = [line.motor_order for line in separable_lines(self.lines, turns, name=recording.name)]
        block = max(round(self.block * rate), 4)
        return recording.with_values(name, values - fitted_lines(values, angle.values, orders, block=block))
