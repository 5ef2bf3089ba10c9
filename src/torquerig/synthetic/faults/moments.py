"""Random moments at which a fault occurs."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.recording import Recording


def drawn_moments(
    recording: Recording, rate: float, rng: np.random.Generator, *, length: int = 1, fault: str
) -> NDArray[np.int_]:
    """Return the first samples of the moments, rising: one at a random place in each of equal parts of the recording.

    Parameters
    ----------
    recording : Recording
    rate : float
        Number per second [1/s]; 0 gives none.
    rng : Generator
    length : int
        Samples of one moment; no two overlap, and the first and the last sample belong to none.
    fault : str
        For the message.

    Raises
    ------
    InputError
        Where the recording is too short for one, or they do not fit between each other.
    """
    number = round(rate * recording.duration)
    if rate > 0 and number == 0:
        raise InputError(
            f"{fault}: {60 * rate:.3g} per minute is none in {recording.duration:.3g} s; write a rate of at least "
            f"{60 / recording.duration:.3g} per minute, or use a longer recording"
        )
    if number == 0:
        return np.empty(0, dtype=np.int_)
    if number * (length + 1) > recording.samples - 2:
        raise InputError(_do_not_fit(fault, number, length, recording))
    ends = 1 + np.arange(number + 1) * (recording.samples - 2) // number
    free = np.diff(ends) - length
    if free.min() < 1:
        raise InputError(_do_not_fit(fault, number, length, recording))
    return np.asarray(ends[:-1] + rng.integers(0, free), dtype=np.int_)


def _do_not_fit(fault: str, number: int, length: int, recording: Recording) -> str:
    return (
        f"{fault}: {number} moments of {length} samples do not fit into {recording.samples} samples; write a lower "
        "rate, or shorter ones"
    )


def within(samples: int, starts: NDArray[np.int_], length: int) -> NDArray[np.bool_]:
    """Return which samples are in a moment of ``length`` samples, shape (samples,)."""
    answer = np.zeros(samples, dtype=bool)
    for start in starts.tolist():
        answer[start : start + length] = True
    return answer


def in_samples(length: float, recording: Recording, *, fault: str) -> int:
    """Return a length [s] in samples; InputError where it is less than half a sample."""
    samples = round(length * recording.sample_rate)
    if length > 0 and samples == 0:
        raise InputError(
            f"{fault}: a length of {1e3 * length:.3g} ms is less than half a sample; write at least "
            f"{1e3 / recording.sample_rate:.3g} ms"
        )
    return samples
