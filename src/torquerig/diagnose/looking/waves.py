"""The waves of lines, ``exp(i phase)``, as powers of one wave where their orders are multiples of one."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.looking.places import Place

Waves = NDArray[np.complex128]

_FINEST = 60  # orders are looked at in sixtieths and coarser
_NEAR = 1e-9


def waves(places: Sequence[Place], angle: NDArray[np.float64], time: NDArray[np.float64]) -> Waves:
    """Return ``exp(i phase)`` of every place, shape (places, samples).

    Orders that are whole multiples of one are powers of its wave, by repeated squaring: a product costs a twentieth of
    a sine and a cosine, and the phase is out by at most the multiple times the rounding of a double.

    Parameters
    ----------
    angle : ndarray, shape (samples,)
        Of the motor [rad].
    time : ndarray, shape (samples,)
        [s].
    """
    answer = np.empty((len(places), angle.size), dtype=np.complex128)
    fractions = [Fraction(place.at).limit_denominator(_FINEST) for place in places]
    even = [
        place.domain == "order" and abs(float(near) - place.at) < _NEAR * place.at
        for place, near in zip(places, fractions, strict=True)
    ]
    base = lcm(*(near.denominator for near, whole in zip(fractions, even, strict=True) if whole))
    doubled = [np.exp(1j / base * angle)] if any(even) else []
    for row, place in enumerate(places):
        if not even[row]:
            answer[row] = np.exp(1j * place.phase(angle, time))
            continue
        multiple = int(fractions[row] * base)
        while len(doubled) < multiple.bit_length():
            doubled.append(doubled[-1] ** 2)
        factors = [doubled[bit] for bit in range(multiple.bit_length()) if multiple >> bit & 1]
        answer[row] = factors[0]
        for factor in factors[1:]:
            answer[row] *= factor
    return answer
