"""Moments of a recording: first sample and one past the last of each; from flags, about jumps, and bridged."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.inspection.runs import runs_of
from torquerig.recordings.recording import Recording

Moments = Sequence[tuple[int, int]]

# a step from one sample to the next has a spectrum that falls by 6 dB an octave and fills the bands above what the
# shafts pass on; bridged over some milliseconds it stays below them
_EITHER_SIDE = 0.0015  # [s]


def moments_of(flags: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first one and one past the last of each run of True."""
    return [(first, first + length) for first, length in runs_of(np.ascontiguousarray(flags, dtype=bool))]


def seams(samples: Iterable[int], recording: Recording) -> list[tuple[int, int]]:
    """Return the moments about the first samples after a jump: first sample and one past the last of each."""
    reach = max(round(_EITHER_SIDE * recording.sample_rate), 1)
    return [(max(at - reach, 0), min(at + reach, recording.samples)) for at in samples]


def bridged(recording: Recording, moments: Moments, *, ends: int = 1) -> Recording:
    """Return the recording with straight lines over the moments without signal, as it is where there are none.

    A line joins the means of the ``ends`` samples before and after a moment.
    """
    if not moments:
        return recording
    volts = recording.torque_values().copy()
    for start, stop in moments:
        first, last = max(start - 1, 0), min(stop, volts.size - 1)
        before, after = volts[max(first + 1 - ends, 0) : first + 1], volts[last : last + ends]
        volts[first : last + 1] = np.linspace(before.mean(), after.mean(), last + 1 - first)
    return recording.with_values(recording.torque_name(), volts)
