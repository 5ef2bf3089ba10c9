"""Resampling of a signal at equal steps of the angle instead of time, and back."""

from __future__ import annotations

from dataclasses import dataclass
from math import floor
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]

_FINEST = 4.0  # steps per turn at most, in samples of the fastest turn
FEWEST_TURNS = 2.0  # of the shaft that turns most: one period has no neighbour to differ from
_SLOWEST_COUNTED = 0.1  # of the fastest speed: slower turns do not determine the step


@dataclass(frozen=True)
class OverAngle:
    """A signal at equal steps of the turned angle.

    Parameters
    ----------
    values : ndarray, shape (steps,)
    per_turn : float
        Steps per turn of the output shaft [1/rev].
    turns : float
        Total turns [rev].
    """

    values: Floats
    per_turn: float
    turns: float


def output_turns(angle: Floats, *, ratio: float) -> Floats:
    """Return the turns of the output shaft since the start, never falling, shape (samples,).

    Parameters
    ----------
    angle : ndarray, shape (samples,)
        Of the motor [rad]. Where the shaft turns back, its turns count upwards, so that a reversal has one axis.
    ratio : float
        Motor turns per output turn [1].
    """
    return np.concatenate([[0.0], np.cumsum(np.abs(np.diff(angle)))]) / (2 * np.pi * ratio)


def over_angle(recording: Recording, turns: Floats, values: Floats | None = None, *, fastest: float = 1.0) -> OverAngle:
    """Return the torque (or ``values``) at equal steps of the turned angle, by local cubics.

    Steps per turn: the samples of the slowest counted turn, but at most four times those of the fastest turn.

    Parameters
    ----------
    recording : Recording
    turns : ndarray, shape (samples,)
        Of the output shaft.
    values : ndarray, shape (samples,), optional
        By default the measured torque.
    fastest : float
        Turns of the fastest shaft per turn of the output shaft [1], >= 1.

    Raises
    ------
    RecordingError
        Where no shaft turns two turns.
    """
    signal = recording.torque() if values is None else values
    total = float(turns[-1] - turns[0])
    if total * fastest < FEWEST_TURNS:
        faster = f", the fastest shaft {floor(total * fastest * 100) / 100:g} times" if fastest > 1 else ""
        raise RecordingError(
            f"{recording.name}: the output shaft turns {floor(total * 100) / 100:g} times{faster}, and orders need two "
            "turns or more of one shaft; take a longer recording"
        )
    steps = np.diff(turns)
    fastest = float(steps.max())
    slowest = max(float(np.percentile(steps, 2)), _SLOWEST_COUNTED * fastest)
    count = int(total * min(1 / slowest, _FINEST / fastest))
    at = _place_of(turns, np.linspace(turns[0], turns[-1], count, endpoint=False))
    return OverAngle(cubic(signal, at), count / total, total)


def over_time(values: Floats, turns: Floats) -> Floats:
    """Return a signal that is given at equal steps of the angle at the samples of ``turns``, shape (samples,).

    ``values`` extend from the first turn to just before the last.
    """
    total = float(turns[-1] - turns[0])
    return cubic(values, (turns - turns[0]) / total * values.size)


def cubic(values: Floats, at: Floats) -> Floats:
    """Return ``values`` between their samples by the cubic through the four nearest, shape of ``at``.

    Its gain at the frequency f (share of the sample rate) is at least about 1 - (pi f)^4 / 4: off by 1e-3 at f = 0.08.
    Beyond the ends the outermost sample is held.
    """
    place = np.clip(at, 0, values.size - 1)
    low = np.clip(place.astype(np.int64), 0, max(values.size - 2, 0))
    t = place - low
    padded = np.concatenate([values[:1], values, values[-1:], values[-1:]])
    before, first, second, after = (padded[low + offset] for offset in range(4))
    # Lagrange's cubic through -1, 0, 1, 2
    return np.asarray(
        first * (1 - t) * (1 + t) * (2 - t) / 2
        + second * t * (1 + t) * (2 - t) / 2
        - before * t * (1 - t) * (2 - t) / 6
        - after * t * (1 - t) * (1 + t) / 6
    )


def _place_of(turns: Floats, wanted: Floats) -> Floats:
    """Return the sample number, with fraction, at which the shaft has turned by ``wanted`` [rev]."""
    return np.asarray(np.interp(wanted, turns, np.arange(turns.size)))
