"""One of two recordings that are compared: its speed and turns, and its torque over time and over the angle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.metrics.changes.segments import Segments, count_for, cut
from torquerig.orders.analysis.angle_resampling import output_turns, over_angle
from torquerig.orders.analysis.frequency_lines import frequency_lines
from torquerig.orders.analysis.line_detection import detected_lines
from torquerig.orders.angle.best_angle import best_motor_angle

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import Kinematics
    from torquerig.recordings.recording import Recording

Floats = NDArray[np.float64]
SHORTEST = 2.0  # [s] a quarter of a second per segment: 4 Hz are its first bin


@dataclass(frozen=True, kw_only=True)
class Side:
    """A recording, prepared.

    Parameters
    ----------
    recording : Recording
    turns : ndarray, shape (samples,), or None
        Of the output shaft; None where its angle is not known.
    no_angle : str
        Why it is not known; empty where it is.
    over_time, over_turns : Segments
        The torque; ``over_turns`` is None without an angle.
    orders, frequencies : tuple of (place, label)
        Lines that were found in it: orders [1/rev], and frequencies [Hz].
    speeds : (float, float)
        Lowest and highest speed of the output shaft, in turns per second [1/s], 1 and 99 % quantile; zero without one.
    """

    recording: Recording
    turns: Floats | None
    no_angle: str
    over_time: Segments
    over_turns: Segments | None
    orders: tuple[tuple[float, str], ...]
    frequencies: tuple[tuple[float, str], ...]
    speeds: tuple[float, float]

    @property
    def is_steady(self) -> bool:
        """Whether the speed stays within 2 %, so that an order has one frequency."""
        return self.speeds[0] > 0 and self.speeds[1] <= 1.02 * self.speeds[0]

    @property
    def turns_per_second(self) -> float:
        """The mean speed of the output shaft [1/s]; 0 where its angle is not known."""
        return 0.0 if self.turns is None else float(self.turns[-1] - self.turns[0]) / self.recording.duration

    @property
    def segment_means(self) -> Floats:
        """The mean of each segment over time, in the unit of the channel."""
        torque, count = self.recording.torque(), self.over_time.values.shape[0]
        length = torque.size // count
        return np.asarray(torque[: count * length].reshape(count, length).mean(axis=1))


def side_of(recording: Recording, kinematics: Kinematics, *, harmonics: int, mains: float) -> Side:
    """Return a recording prepared for a comparison.

    Raises
    ------
    RecordingError
        For a recording that is too short, or whose torque has samples that are not numbers.
    """
    torque, rate = recording.torque(), recording.sample_rate
    if recording.duration < SHORTEST:
        raise RecordingError(f"{recording.name}: {recording.duration:.3g} s are too short to compare; record at least "
                             f"{SHORTEST:g} s")  # fmt: skip
    if not np.isfinite(torque).all():
        raise RecordingError(f"{recording.name}: the torque has samples that are not numbers; repair them first, see "
                             "torquerig info")  # fmt: skip
    try:
        angle = best_motor_angle(recording, kinematics.lines(harmonics), ratio=kinematics.ratio)
        turns = output_turns(angle.values, ratio=kinematics.ratio)
        evenly = over_angle(recording, turns, fastest=kinematics.fastest_shaft[1])
    except RecordingError as error:
        count = count_for(recording.duration * 5)
        alone = tuple((one.frequency, _mains(one.mains_multiple)) for one in frequency_lines(recording, mains=mains))
        return Side(
            recording=recording, turns=None, no_angle=str(error), over_time=cut(torque, rate, count), over_turns=None,
            orders=(), frequencies=alone, speeds=(0.0, 0.0),
        )  # fmt: skip
    count = count_for(evenly.turns)
    found = detected_lines(recording, turns, kinematics, harmonics=harmonics, mains=mains)
    return Side(
        recording=recording, turns=turns, no_angle="", over_time=cut(torque, rate, count),
        over_turns=cut(evenly.values, evenly.per_turn, count), speeds=_speeds(turns, rate),
        orders=tuple((one.place, one.label) for one in found if one.detected_over == "order"),
        frequencies=tuple((one.place, one.label) for one in found if one.detected_over == "frequency"),
    )  # fmt: skip


def _mains(multiple: int | None) -> str:
    return f"{multiple} x mains" if multiple else ""


def _speeds(turns: Floats, rate: float) -> tuple[float, float]:
    step = max(round(0.05 * rate), 1)
    low, high = np.percentile(np.diff(turns[::step]) * rate / step, (1, 99))
    return float(low), float(high)
