"""Standard error of an rms from one record of limited length, and the length that makes it small."""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

BLOCKS = 10  # of equal length; fewer leave the standard error itself unknown within 25 %
SHORTEST_BLOCK = 0.05  # [s] shorter blocks of a load with a 1.5 Hz part are not independent


def rms_standard_error(signal: NDArray[np.float64], *, rate: float) -> float | None:
    """Return the standard error of the rms of a random signal, in its unit; None for less than 10 blocks of 0.05 s.

    Batch means: the mean squares of ``BLOCKS`` stretches of the record scatter by their own randomness, and the mean of
    all scatters by ``1 / sqrt(BLOCKS)`` of it. Source: Law, Simulation Modeling and Analysis, ch. 9 (batch means).
    Too small for a signal that is correlated over longer than a block.

    Parameters
    ----------
    signal : ndarray, shape (samples,)
        The difference whose rms is of interest, its mean included.
    rate : float
        [Hz]
    """
    length = signal.size // BLOCKS
    if length < SHORTEST_BLOCK * rate:
        return None
    squares = np.mean(signal[: BLOCKS * length].reshape(BLOCKS, length) ** 2, axis=1)
    whole = float(squares.mean())
    return 0.0 if whole == 0 else float(squares.std(ddof=1)) / sqrt(BLOCKS) / (2 * sqrt(whole))


def length_for(relative: float, *, now: float, length: float) -> float:
    """Return the record length [s] that reaches a relative standard error, from that ``now`` of ``length`` [s]."""
    return length * (now / relative) ** 2
