"""Comb filter: subtracts everything periodic with a line's period, but keeps the mean; zero-phase or causal."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.orders.angle.best_angle import best_motor_speed
from torquerig.recordings.set_point import set_point_speed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Comb:
    """Subtracts, for each line, the mean over ``2 periods + 1`` periods around each sample, less its slow mean.

    Each line is a fundamental whose harmonics are all removed; 0 Hz is kept. (An IIR comb removes the mean too, and
    needs a sample rate that is a whole multiple of the line.)

    Parameters
    ----------
    lines : tuple of KinematicLine
        The fundamentals, at the run's mean speed.
    periods : int
        On either side, >= 1; a tooth of the comb is about 1 / (2 periods + 1) of the fundamental wide.

    Notes
    -----
    Source: the averaging comb of Braun 1975 with the mean added again. A period is not a whole number of samples;
    linear interpolation between samples attenuates high harmonics by (f / rate)^2 pi^2 / 6.
    """

    lines: tuple[KinematicLine, ...]
    periods: int = 10

    def __post_init__(self) -> None:
        _check_periods(self.periods)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the combs; RecordingError where it is shorter than three periods."""
        return _applied(self, recording, best_motor_speed(recording, self.lines).value if self.lines else 0.0)

    def reach(self, head: Recording) -> float:
        """Return the length of the window on either side of a sample [s]."""
        speed = abs(set_point_speed(head, "combs"))
        return sum((self.periods + 1) / line.frequency(speed) for line in self.lines)


@dataclass(frozen=True, kw_only=True)
class CausalComb:
    """The causal form: the mean over the last ``2 periods + 1`` periods, at the set-point of the speed.

    Parameters
    ----------
    lines : tuple of KinematicLine
        The fundamentals.
    periods : int
        As in :class:`Comb`. Slow load is delayed by half a period of each line (:meth:`delay`).
    """

    lines: tuple[KinematicLine, ...]
    periods: int = 10

    def __post_init__(self) -> None:
        _check_periods(self.periods)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the combs; RecordingError where it is shorter than three periods."""
        return _applied(self, recording, abs(set_point_speed(recording, "combs")) if self.lines else 0.0)

    def delay(self, recording: Recording) -> float:
        """Return the delay of slow load [s]."""
        speed = abs(set_point_speed(recording, "combs"))
        return sum(0.5 / line.frequency(speed) for line in self.lines)

    def reach(self, head: Recording) -> float:
        """Return the length of the window before a sample [s]."""
        speed = abs(set_point_speed(head, "combs"))
        return sum((2 * self.periods + 1) / line.frequency(speed) for line in self.lines)


def without_repeats(values: Floats, period: float, shifts: range, *, centred: bool) -> Floats:
    """Return the values less their mean over shifts by whole periods; the mean over one period is kept.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Any unit.
    period : float
        [samples], not necessarily whole.
    shifts : range
        The shifts in whole periods; samples beyond the ends are not counted.
    centred : bool
        Whether the mean over one period is centred on a sample or ends there.
    """
    at = np.arange(values.size, dtype=np.float64)
    total, count = np.zeros(values.size), np.zeros(values.size)
    for shift in shifts:
        moved = at + shift * period
        inside = (moved >= 0) & (moved <= values.size - 1)
        total[inside] += np.interp(moved[inside], at, values)
        count += inside
    repeated = total / count
    sums = np.concatenate([[0.0], np.cumsum(0.5 * (repeated[1:] + repeated[:-1]))])
    last = np.clip(at + (0.5 * period if centred else 0.0), min(period, at[-1]), at[-1])
    slow = (np.interp(last, at, sums) - np.interp(np.maximum(last - period, 0.0), at, sums)) / period
    if not centred:
        first_period = at < period  # the mean over one period is not yet known
        slow[first_period] = repeated[first_period]
    return np.asarray(values - (repeated - slow))


def _applied(stage: Comb | CausalComb, recording: Recording, speed: float) -> Recording:
    name, rate = recording.torque_name(), recording.sample_rate
    values, centred = recording.channels[name].values, isinstance(stage, Comb)
    shifts = range(-stage.periods, stage.periods + 1) if centred else range(-2 * stage.periods, 1)
    for period in sorted({rate * 2 * pi / (line.motor_order * speed) for line in stage.lines}):
        if period < 2 or values.size < 3 * period:
            raise RecordingError(
                f"{recording.name}: a comb of period {period / rate:.4g} s needs two samples each and three of them, "
                "and this recording is too slow or too short; take another"
            )
        values = without_repeats(values, period, shifts, centred=centred)
    return recording.with_values(name, values)


def _check_periods(periods: int) -> None:
    if periods < 1:
        raise InputError(f"a comb over {periods} periods is not possible; write at least 1")
