"""What is left when everything that repeats after one period of a line is subtracted, its mean kept: a comb."""

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
    """Subtracts, for each line, the mean of ``2 periods + 1`` periods around each sample, less its own slow mean.

    Each line named is a fundamental: all its harmonics go with it, and 0 Hz stays (an IIR comb takes the mean along,
    and needs a rate that is a whole multiple of the line).

    Parameters
    ----------
    lines : tuple of KinematicLine
        The fundamentals, at the run's mean speed.
    periods : int
        To either side, >= 1; a tooth of the comb is about 1 / (2 periods + 1) of the fundamental wide.

    Notes
    -----
    Source: the averaging comb of Braun 1975 with the mean put back. A period is no whole number of samples: values
    between samples are taken on straight lines, which costs high harmonics (f / rate)^2 pi^2 / 6 of themselves.
    """

    lines: tuple[KinematicLine, ...]
    periods: int = 10

    def __post_init__(self) -> None:
        _check_periods(self.periods)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the combs; RecordingError where it is shorter than three periods."""
        return _applied(self, recording, best_motor_speed(recording, self.lines).value if self.lines else 0.0)

    def reach(self, head: Recording) -> float:
        """Return how far it looks to either side [s]."""
        speed = abs(set_point_speed(head, "combs"))
        return sum((self.periods + 1) / line.frequency(speed) for line in self.lines)


@dataclass(frozen=True, kw_only=True)
class CausalComb:
    """The same over ``2 periods + 1`` periods past, at the set-point: no sample waits for a later one.

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
        """Return by how much slow load is late [s]."""
        speed = abs(set_point_speed(recording, "combs"))
        return sum(0.5 / line.frequency(speed) for line in self.lines)

    def reach(self, head: Recording) -> float:
        """Return how far back it looks [s]."""
        speed = abs(set_point_speed(head, "combs"))
        return sum((2 * self.periods + 1) / line.frequency(speed) for line in self.lines)


def without_repeats(values: Floats, period: float, shifts: range, *, centred: bool) -> Floats:
    """Return the values less the mean over whole ``period`` shifts, which keeps its own mean over one period.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Any unit.
    period : float
        [samples], not necessarily whole.
    shifts : range
        Which whole periods are averaged; those beyond the ends count for nothing.
    centred : bool
        Whether the mean over one period lies around a sample or before it.
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
        begun = at < period  # no whole period has passed: nothing can be told from the mean yet
        slow[begun] = repeated[begun]
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
        raise InputError(f"a comb over {periods} periods cannot be; write at least 1")
