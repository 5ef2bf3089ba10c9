"""What is left when fitted sines of the known lines, following the motor's angle, are subtracted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.orders.analysis.line_fit import FEWEST_PERIODS, fitted_lines
from torquerig.orders.angle.best_angle import best_motor_angle

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class HarmonicRegression:
    """Subtracts the least-squares sines of ``lines`` from the torque and keeps everything else, the mean included.

    The angle is the best that the recording has (:func:`~torquerig.orders.angle.best_angle.best_motor_angle`).

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to subtract.
    block : float
        Length over which a line's amplitude and phase are taken as one [s], > 0; blocks overlap by half, and a
        shorter recording is one block.

    Notes
    -----
    Source: handbook 0 (order-locked lines need order tracking; Fyfe & Munck 1997). Where it stops being true:
    load within about 1 / block of a line is subtracted with it, and an amplitude that changes faster than a block is
    followed only in part. Without an encoder nothing follows faster than some tenths of a second.
    """

    lines: tuple[KinematicLine, ...]
    block: float = 4.0

    def __post_init__(self) -> None:
        if not self.block > 0:
            raise InputError(f"blocks of {self.block} s cannot be fitted; write for example 4 s")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the lines; RecordingError where it is too short or no angle can be had."""
        if not self.lines:
            return recording
        name = recording.torque_name()
        values, rate = recording.channels[name].values, recording.sample_rate
        angle = best_motor_angle(recording, self.lines)
        orders = [line.motor_order for line in self.lines]
        turns = np.abs(np.diff(angle.values)).sum() / (2 * np.pi)
        if turns * max(orders) < FEWEST_PERIODS:
            raise RecordingError(
                f"{recording.name}: no line passes {FEWEST_PERIODS:g} periods in the {turns:.3g} motor turns of this "
                "recording; take a longer one"
            )
        block = max(round(self.block * rate), 4)
        return recording.with_values(name, values - fitted_lines(values, angle.values, orders, block=block))
