"""Synchronous average: the mean turn of the output shaft is subtracted, with everything periodic in the turn."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.orders.angle.best_angle import best_motor_angle

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]

_FEWEST_TURNS = 2.0


@dataclass(frozen=True, kw_only=True)
class SynchronousAverage:
    """Averages the torque over turns at equal angles and subtracts the deviation of this mean turn from its mean.

    Parameters
    ----------
    ratio : float
        Motor turns per output turn [1], > 0.
    lines : tuple of KinematicLine
        Lines for estimating the angle from the torque, where no channel gives it.

    Notes
    -----
    Source: Braun 1975, Mechanical Signature Analysis; McFadden 1987, Mech. Syst. Signal Process. 1(1), 83-95. A comb
    over all whole output orders; over n turns it also removes 1 / n of the power of everything else. Limits: orders
    that are not whole numbers of the output shaft, amplitudes that change over the record, lines above a tenth of the
    sample rate (the mean turn has as many points as a turn has samples, interpolated linearly).
    """

    ratio: float
    lines: tuple[KinematicLine, ...] = ()

    def __post_init__(self) -> None:
        if not self.ratio > 0:
            raise InputError(
                f"a gear ratio of {self.ratio} is not possible; write motor turns per output turn, more than 0"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` less its mean turn; RecordingError with fewer than two turns."""
        name = recording.torque_name()
        values = recording.channels[name].values
        turns = best_motor_angle(recording, self.lines, ratio=self.ratio).values / (2 * pi * self.ratio)
        whole = abs(float(turns[-1] - turns[0])) if turns.size else 0.0
        if whole < _FEWEST_TURNS:
            raise RecordingError(
                f"{recording.name}: the output shaft turns {whole:.3g} times, and a mean turn needs {_FEWEST_TURNS:g}; "
                "take a longer recording"
            )
        points = max(round(values.size / whole), 4)
        mean = mean_turn(values, turns, points)
        place = np.mod(turns, 1.0) * points
        repeated = np.interp(place, np.arange(points + 1), np.append(mean, mean[0]))
        return recording.with_values(name, values - (repeated - repeated.mean()))


def mean_turn(values: Floats, turns: Floats, points: int) -> Floats:
    """Return the mean of the values at ``points`` equal angles of a turn, shape (points,).

    A sample between two points contributes to both, by linear weights.
    """
    place = np.mod(turns, 1.0) * points
    lower = np.minimum(place.astype(np.int64), points - 1)
    share = place - lower
    upper = (lower + 1) % points
    weight = np.bincount(lower, 1 - share, points) + np.bincount(upper, share, points)
    total = np.bincount(lower, (1 - share) * values, points) + np.bincount(upper, share * values, points)
    filled = weight > 1e-6
    return np.interp(np.arange(points), np.flatnonzero(filled), total[filled] / weight[filled], period=points)
