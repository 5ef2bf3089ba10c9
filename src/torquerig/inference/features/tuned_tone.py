"""Frequency of a tone by its phases over whole runs, which determine it better than single blocks do."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.noise_ratios import NoiseRatios

Complex = NDArray[np.complex128]

_PIECES = 8  # of a block, each with one phase: a tone within half a bin turns by a sixteenth of a turn in one
_POINTS = 41  # frequencies that are compared


def tuned(frequency: float, ratios: Sequence[NoiseRatios], *, within: float) -> float:
    """Return the frequency [Hz] near the given one at which the blocks of all runs show most power.

    The blocks of a run are transformed together, in their times, so that n of them resolve n times as fine; the powers
    of the runs are added, each over its mean square. Not valid beyond ``within`` [Hz]: held-out blocks leave gaps, and
    side lobes of the transform lie there.
    """
    offset = np.linspace(-within, within, _POINTS)
    power = np.zeros(_POINTS)
    for run in {id(each.run): each.run for each in ratios}.values():
        own = [each for each in ratios if each.run is run]
        total, square = np.zeros(_POINTS, dtype=np.complex128), 0.0
        for each in own:
            time, piece = _pieces(each, frequency)
            total += np.exp(-2j * pi * offset[:, None] * time) @ piece
            square += float(each.rest @ each.rest)
        power += np.abs(total) ** 2 / max(square, 1e-300)
    return frequency + float(offset[int(np.argmax(power))])


def _pieces(each: NoiseRatios, frequency: float) -> tuple[NDArray[np.float64], Complex]:
    """Return the middles [s] of the pieces of a block and its windowed parts of a frequency in them."""
    size = each.rest.size // _PIECES
    time = (each.start + np.arange(size * _PIECES)) / each.run.rate
    wave = np.exp(-2j * pi * frequency * time) * each.rest[: time.size] * np.hanning(each.rest.size)[: time.size]
    return time.reshape(_PIECES, size).mean(axis=1), wave.reshape(_PIECES, size).sum(axis=1)
