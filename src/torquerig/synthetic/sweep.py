"""A sine with a varying frequency."""

from __future__ import annotations

from math import log

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError


def sweep(
    time: NDArray[np.float64], *, start: float, stop: float, duration: float, logarithmic: bool = True
) -> NDArray[np.float64]:
    """Return a sine of amplitude 1 whose frequency runs from ``start`` to ``stop`` over ``duration``.

    Parameters
    ----------
    time : ndarray, shape (samples,)
        [s] from the start of the sweep.
    start, stop : float
        [Hz], > 0; a falling sweep has ``stop`` below ``start``.
    duration : float
        [s], > 0.
    logarithmic : bool
        Whether the time per octave is constant; else the time per hertz.

    Notes
    -----
    Source: Farina 2000, AES Convention 108, paper 5093, eq. 5 (the phase is the integral of the frequency).
    """
    if not (start > 0 and stop > 0 and duration > 0):
        raise InputError(f"a sweep from {start:g} to {stop:g} Hz in {duration:g} s cannot be; all must be above 0")
    if not logarithmic or start == stop:
        turns = start * time + (stop - start) * time**2 / (2 * duration)
    else:
        octaves = log(stop / start)
        turns = start * duration / octaves * np.expm1(time / duration * octaves)
    return np.asarray(np.sin(2 * np.pi * turns))
