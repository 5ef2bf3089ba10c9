"""A hum of the mains that hides faults of samples: it goes on where a signal is lost, and makes no jump itself."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.repair.strong_tone import power_of, without_waves
from torquerig.recordings.spectrum import between_bins

Floats = NDArray[np.float64]

GRIDS = (50.0, 60.0)  # [Hz]
TOLERANCE = 0.006  # grids keep within some tenths of a per cent [1]
_BESIDE = 8.0  # [Hz] either way of the grid's frequency
_STANDS_OUT = 30.0  # power over the median beside it
_HARMONICS = 8


def grid_line(power: Floats, step: float) -> float | None:
    """Return the frequency [Hz] of the clearest line at a grid's frequency, between the bins; None where none is.

    ``power`` and ``step`` are as of ``power_of``.
    """
    clearest, answer = _STANDS_OUT, None
    for grid in GRIDS:
        low, high = int(grid * (1 - TOLERANCE) / step), int(np.ceil(grid * (1 + TOLERANCE) / step)) + 1
        near = power[max(int((grid - _BESIDE) / step), 0) : int((grid + _BESIDE) / step)]
        if low < 1 or high >= power.size or not near.size:
            continue
        at = low + int(np.argmax(power[low:high]))
        height = float(power[at] / (np.median(near) + 1e-300))
        if height > clearest:
            clearest, answer = height, step * between_bins(power, at)
    return answer


def without_hum(volts: Floats, rate: float) -> Floats | None:
    """Return the samples without a hum and its harmonics, straight in time; None where no hum stands out."""
    frequency = grid_line(*power_of(volts, rate))
    if frequency is None:
        return None
    return without_waves(volts, rate, frequency, harmonics=_HARMONICS)
