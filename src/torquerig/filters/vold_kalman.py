"""Vold-Kalman order tracking filter: each line is subtracted with a smooth amplitude over the angle."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.filters.counted_periods import separable_lines
from torquerig.orders.analysis.order_envelope import HOPS_PER_TURN, hop_sums, hops_of, resolved_orders, without_lines
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.orders.angle.second_differences import second_difference_bands
from torquerig.recordings.set_point import set_point_speed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]

_REACH = 4.0  # multiples of 1 / (2 pi half_width) turns after which the weight of a sample is below 1 %


@dataclass(frozen=True, kw_only=True)
class VoldKalman:
    """Second generation, two poles: least squares of torque less lines, plus the amplitudes' second differences.

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to remove; the angle is the recording's best one.
    half_width : float
        Half the width of each band at -3 dB [orders of the output shaft, 1/rev], > 0.

    Notes
    -----
    Source: Vold & Leuridan 1993, SAE 931288; Tuma 2005, "Setting the passband width in the Vold-Kalman order tracking
    filter", 12th ICSV, for the weight of a given width. The amplitudes are solved at eighths of a turn (from the
    demodulated torque averaged there), because at the full rate the normal equations of a narrow band exceed double
    precision. Each line is solved separately, with one banded Cholesky factor for all; lines nearer than a few
    half-widths are not separated. At the ends the amplitudes are extrapolated linearly.
    """

    lines: tuple[KinematicLine, ...]
    half_width: float = 0.05

    def __post_init__(self) -> None:
        if not 0 < self.half_width < HOPS_PER_TURN / 4:
            raise InputError(
                f"bands of half-width {self.half_width} orders are not possible; "
                f"write more than 0 and less than {HOPS_PER_TURN / 4:g}"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the lines; RecordingError where there is no angle or the shaft does not turn."""
        if not self.lines:
            return recording
        angle = best_motor_angle(recording, self.lines)
        hops = hops_of(angle.values, ratio=self.lines[0].output_order / self.lines[0].motor_order)
        if hops is None or hops.samples.size < HOPS_PER_TURN:
            raise RecordingError(
                f"{recording.name}: the output shaft turns less than once, too little to follow an order"
            )
        name = recording.torque_name()
        values = recording.channels[name].values
        lines = separable_lines(self.lines, hops.turned, name=recording.name)
        orders = resolved_orders([line.motor_order for line in lines], hops.fastest)
        sums = hop_sums(values, hops, orders)
        amplitudes = smoothest(sums, hops.samples, half_width=self.half_width / HOPS_PER_TURN)
        return recording.with_values(name, without_lines(values, hops, orders, amplitudes))

    def reach(self, head: Recording) -> float:
        """Return the length on either side over which samples have weight [s]."""
        speed = abs(set_point_speed(head, "bands in orders"))
        ratio = self.lines[0].output_order / self.lines[0].motor_order if self.lines else 1.0
        return _REACH * ratio / (self.half_width * speed)


def smoothest(sums: Floats, samples: Floats, *, half_width: float) -> Floats:
    """Return the amplitudes at the edges of the hops, shape (2, orders, hops + 1).

    Parameters
    ----------
    sums : ndarray, shape (2, orders, hops)
        Sums of the torque times cos and sin.
    samples : ndarray, shape (hops,)
        Samples per hop.
    half_width : float
        At -3 dB [periods per hop].
    """
    from scipy.linalg import solveh_banded

    hops = samples.size
    weight = float(samples.mean()) * (sqrt(2) - 1) / (2 * sin(pi * half_width)) ** 4
    bands = second_difference_bands(hops) * weight
    bands[2] += samples
    solved = solveh_banded(bands, 2 * sums.reshape(-1, hops).T).T.reshape(sums.shape)
    inner = 0.5 * (solved[..., 1:] + solved[..., :-1])
    first = 1.5 * solved[..., :1] - 0.5 * solved[..., 1:2]
    last = 1.5 * solved[..., -1:] - 0.5 * solved[..., -2:-1]
    return np.concatenate([first, inner, last], axis=2)
