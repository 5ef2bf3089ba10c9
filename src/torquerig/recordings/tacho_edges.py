"""The edges of a tacho's pulse train, and how many pulses a turn of the motor has."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.run import Run

PER_MOTOR_TURN, PER_OUTPUT_TURN = "tacho_pulses_per_motor_turn", "tacho_pulses_per_output_turn"
"""Keys of the run's conditions that state the pulses of a tacho; the second belongs to one on the output shaft."""


def stated_pulses(run: Run, *, ratio: float | None) -> float | None:
    """Return the pulses of the tacho per turn of the motor [1], as stated; None where they, or the ratio, are not.

    Parameters
    ----------
    run : Run
    ratio : float or None
        Motor turns per output turn [1], for a tacho on the output shaft.
    """
    motor, output = (run.others.get(key) for key in (PER_MOTOR_TURN, PER_OUTPUT_TURN))
    if isinstance(motor, int | float) and not isinstance(motor, bool) and motor > 0:
        return float(motor)
    if ratio and isinstance(output, int | float) and not isinstance(output, bool) and output > 0:
        return float(output) / ratio
    return None


def rising_edges(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the positions [samples, with fractions] where a pulse train rises through its middle, shape (edges,)."""
    if values.size < 3:
        return np.zeros(0)
    low, high = np.percentile(values, [5, 95])
    if high <= low:  # pulses shorter than a twentieth of the period
        low, high = values.min(), values.max()
    if high <= low:
        return np.zeros(0)
    middle, armed = 0.5 * (low + high), 0.5 * (low + high) - 0.25 * (high - low)
    above = np.flatnonzero((values[1:] >= middle) & (values[:-1] < middle))
    low_before = np.maximum.accumulate(np.where(values < armed, np.arange(values.size), -1))[above]
    kept = np.flatnonzero(np.diff(low_before, prepend=-1) > 0)  # one edge per pulse in spite of noise
    at = above[kept]
    return np.asarray(at + (middle - values[at]) / (values[at + 1] - values[at]))
