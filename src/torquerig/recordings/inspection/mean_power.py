"""The averaged spectrum of a recording that comes in blocks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.spectrum import hann_spectrum

SEGMENT = 2**18
"""Samples of a segment at most: 0.1 Hz from bin to bin at 25 kHz."""


@dataclass(frozen=True, kw_only=True)
class MeanPower:
    """Squared zero-to-peak amplitudes summed over segments, shape (bins,), [unit^2].

    ``segment`` is the number of samples of each segment, and ``count`` the number of segments.
    """

    segment: int
    count: int
    power: NDArray[np.float64]

    def spectrum(self, rate: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return frequencies [Hz] and the root mean square of the segments' amplitudes, shape (bins,) each."""
        frequencies = np.asarray(np.arange(self.power.size) * (rate / self.segment), dtype=np.float64)
        return frequencies, np.asarray(np.sqrt(self.power / max(self.count, 1)), dtype=np.float64)


def mean_power_of(values: NDArray[np.float64], *, segment: int) -> MeanPower:
    """Return the summed power of the complete segments of ``values`` without missing numbers, with a Hann window."""
    power, count = np.zeros(segment // 2 + 1), 0
    for first in range(0, values.size - segment + 1, segment):
        part = values[first : first + segment]
        if np.isfinite(part).all():
            power += hann_spectrum(part, 1.0)[1] ** 2
            count += 1
    return MeanPower(segment=segment, count=count, power=power)


def joined_powers(left: MeanPower, right: MeanPower) -> MeanPower:
    """Return the sum of both; segments must be equally long."""
    return MeanPower(segment=left.segment, count=left.count + right.count, power=left.power + right.power)
