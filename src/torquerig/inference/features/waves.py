"""The waves of lines, ``exp(i phase)``, made piece by piece where they are asked for.

A hundred of them over a run are half a gigabyte, which takes far longer to fill and to read than to make.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.kernel import summed_waves, weighted_waves
from torquerig.inference.places import Place

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

_PIECE = 4096  # samples


class Waves:
    """``exp(i phase)`` of the lines at ``places`` over a stretch of samples.

    Parameters
    ----------
    places : sequence of Place
    angle : ndarray, shape (samples,)
        Of the motor [rad].
    time : ndarray, shape (samples,)
        [s].
    """

    def __init__(self, places: Sequence[Place], angle: Floats, time: Floats) -> None:
        self.lines, self.samples = len(places), angle.size
        self._turning = np.array([place.domain == "order" for place in places], dtype=bool)
        self._rate = np.array([place.at if place.domain == "order" else 2 * pi * place.at for place in places])
        self._angle, self._time = np.ascontiguousarray(angle), np.ascontiguousarray(time)

    def pieces(self) -> Iterator[slice]:
        """Yield slices of the samples, short enough for all waves to stay near the processor."""
        for start in range(0, self.samples, _PIECE):
            yield slice(start, min(start + _PIECE, self.samples))

    def weighted(self, part: slice, weight: Floats) -> Floats:
        """Return the real parts, then the imaginary ones with the other sign, times the samples' weights.

        Shape (2 lines, samples of the part); ``weight`` is of shape (samples of the part,).
        """
        answer = np.empty((2 * self.lines, weight.size))
        weighted_waves(self._rate, self._turning, self._angle[part], self._time[part], weight, answer)
        return answer

    def summed(self, amplitude: Complex) -> Floats:
        """Return the sum of lines of these amplitudes, ``Re sum_k amplitude_k exp(i phase_k)``, shape (samples,)."""
        answer = np.zeros(self.samples)
        size = np.ascontiguousarray(amplitude.real), np.ascontiguousarray(amplitude.imag)
        for part in self.pieces():
            summed_waves(self._rate, self._turning, self._angle[part], self._time[part], *size, answer[part])
        return answer
