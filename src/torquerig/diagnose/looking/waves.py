"""The waves of lines, ``exp(i phase)``, as powers of one wave where their orders are multiples of one.

A hundred of them over a run are half a gigabyte, which takes ten times as long to fill and to read as to use: so they
are made piece by piece, where they are asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import lcm

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.looking.places import Place

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

PIECE = 4096  # samples
_FINEST = 60  # orders are looked at in sixtieths and coarser
_NEAR = 1e-9


class Waves:
    """``exp(i phase)`` of every place, an array of shape (places, samples) of which any columns may be asked.

    Orders that are whole multiples of one are powers of its wave, by repeated squaring: a product costs a twentieth of
    a sine and a cosine, and the phase is out by at most the multiple times the rounding of a double.

    Parameters
    ----------
    places : sequence of Place
    angle : ndarray, shape (samples,)
        Of the motor [rad].
    time : ndarray, shape (samples,)
        [s].
    """

    def __init__(self, places: Sequence[Place], angle: Floats, time: Floats) -> None:
        self.shape = (len(places), angle.size)
        self._places, self._angle, self._time = places, angle, time
        fractions = [Fraction(place.at).limit_denominator(_FINEST) for place in places]
        even = [
            place.domain == "order" and abs(float(near) - place.at) < _NEAR * place.at
            for place, near in zip(places, fractions, strict=True)
        ]
        self._base = lcm(*(near.denominator for near, whole in zip(fractions, even, strict=True) if whole))
        multiples = [int(each * self._base) for each in fractions]
        self._multiples = [each if whole else None for each, whole in zip(multiples, even, strict=True)]

    def __getitem__(self, at: tuple[slice, slice]) -> Complex:
        """Return ``exp(i phase)`` of the places and the samples of two slices."""
        rows, part = range(self.shape[0])[at[0]], at[1]
        angle, time = self._angle[part], self._time[part]
        answer = np.empty((len(rows), angle.size), dtype=np.complex128)
        doubled = [np.exp(1j / self._base * angle)] if any(self._multiples) else []
        for at_row, row in enumerate(rows):
            multiple = self._multiples[row]
            if multiple is None:
                answer[at_row] = np.exp(1j * self._places[row].phase(angle, time))
                continue
            while len(doubled) < multiple.bit_length():
                doubled.append(doubled[-1] ** 2)
            factors = [doubled[bit] for bit in range(multiple.bit_length()) if multiple >> bit & 1]
            answer[at_row] = factors[0]
            for factor in factors[1:]:
                answer[at_row] *= factor
        return answer


def pieces(samples: int) -> Iterator[slice]:
    """Yield the slices of a run's samples in which waves are best made."""
    yield from (slice(start, min(start + PIECE, samples)) for start in range(0, samples, PIECE))


def summed(waves: Waves | Complex, amplitude: Complex) -> Floats:
    """Return the sum of lines of these amplitudes, ``Re sum_k amplitude_k exp(i phase_k)``, shape (samples,)."""
    answer = np.empty(waves.shape[1])
    for part in pieces(answer.size):
        answer[part] = (amplitude @ waves[:, part]).real
    return answer
