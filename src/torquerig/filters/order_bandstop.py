"""Order band-stop: a narrow band around each order is removed over the motor's angle, at any speed."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.filters.counted_periods import separable_lines
from torquerig.orders.analysis.order_envelope import (
    HOPS_PER_TURN,
    envelope,
    hop_sums,
    hops_of,
    resolved_orders,
    without_lines,
)
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.recordings.set_point import set_point_speed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class OrderBandstop:
    """Demodulates each line by the motor's angle, averages its amplitude over turns, and subtracts the line.

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to remove; the angle is the recording's best one.
    half_width : float
        Half the width of each band at -6 dB [orders of the output shaft, 1/rev], > 0: a line's amplitude is averaged
        over a Hann window of 1 / half_width turns. With a whole number of turns, lines at other whole orders do not
        influence each other.

    Notes
    -----
    Source: synchronous demodulation (Fyfe & Munck 1997, Mech. Syst. Signal Process. 11(2), on why the angle is
    needed); the band is that of a Hann window, with sidelobes at -32 dB and falling. Within half a window of the ends
    the amplitude of the first and last complete window is held. Limits: load within a band is removed with the line,
    and an amplitude that changes within a window is averaged.
    """

    lines: tuple[KinematicLine, ...]
    half_width: float = 0.05

    def __post_init__(self) -> None:
        if not self.half_width > 0:
            raise InputError(f"bands of half-width {self.half_width} orders remove nothing; write for example 0.05")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the bands; RecordingError where there is no angle or the shaft does not turn."""
        if not self.lines:
            return recording
        angle = best_motor_angle(recording, self.lines)
        hops = hops_of(angle.values, ratio=self.lines[0].output_order / self.lines[0].motor_order)
        if hops is None:
            raise RecordingError(
                f"{recording.name}: the shaft does not turn in this recording, so that no order can be removed"
            )
        name = recording.torque_name()
        values = recording.channels[name].values
        lines = separable_lines(self.lines, hops.turned, name=recording.name)
        orders = resolved_orders([line.motor_order for line in lines], hops.fastest)
        window = max(2 * round(0.5 * HOPS_PER_TURN / self.half_width), 2)
        sums = hop_sums(values, hops, orders)
        return recording.with_values(name, without_lines(values, hops, orders, envelope(sums, hops.samples, window)))

    def reach(self, head: Recording) -> float:
        """Return the length of one window at the set-point [s]."""
        speed = abs(set_point_speed(head, "bands in orders"))
        ratio = self.lines[0].output_order / self.lines[0].motor_order if self.lines else 1.0
        return 2 * pi * ratio / (self.half_width * speed)
