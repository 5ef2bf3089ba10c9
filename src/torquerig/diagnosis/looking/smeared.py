"""Lines of a run whose angle was not measured: their power is gathered over the width that they are smeared to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.regression import HANN_NOISE

Floats = NDArray[np.float64]

WIDE = 2.0  # bins of a line under a Hann window: what is smeared less is better fitted beside its neighbours
_OWN = 0.45  # of the way to the next line
_BESIDE = 2.0  # the floor is taken from bins up to so many widths away


@dataclass(frozen=True)
class Gathered:
    """A line whose power was gathered.

    Parameters
    ----------
    amplitude : float
        Zero to peak [unit].
    widening : float
        By what the variance of a coherent estimate must be multiplied [1].
    reach : float
        Whatever stands within so many bins of the line has been gathered with it.
    floor : float
        One-sided density that it stands in [unit^2/Hz], the skirts of stronger lines beside it included.
    """

    amplitude: float
    widening: float
    reach: float
    floor: float


def gathered(values: Floats, rate: float, lines: Sequence[float], *, smeared: float) -> list[Gathered]:
    """Return the amplitude of each line [Hz] from the power within ``smeared`` of its frequency, less the floor there.

    A line whose phase strays keeps its power and loses its coherent amplitude (by exp(-sigma^2 / 2) for a phase of
    sigma rad); only the floor under the gathered bins, taken from their neighbours' median, limits this estimate.
    """
    window = np.hanning(values.size)
    density = 2 * np.abs(np.fft.rfft((values - values.mean()) * window)) ** 2 / ((window**2).sum() * rate)
    step = rate / values.size
    answer = []
    for line in lines:
        neighbour = min((abs(line - other) for other in lines if other != line), default=np.inf)
        at, half = line / step, max(WIDE, min(smeared * line, _OWN * neighbour) / step)
        low, high = int(np.ceil(at - half)), int(np.floor(at + half)) + 1
        first, last = max(int(at - _BESIDE * half) - 1, 1), min(int(at + _BESIDE * half) + 2, density.size)
        beside = np.concatenate([density[first : max(low, first)], density[min(high, last) : last]])
        floor = float(np.median(beside)) / np.log(2) if beside.size else 0.0
        power = float((density[max(low, 1) : high] - floor).sum()) * step
        widening = float(np.sqrt(max(high - low, 1) / HANN_NOISE))
        # what chance adds to a coherent estimate, so that both are read alike
        chance = 2 * HANN_NOISE * widening * floor * step
        answer.append(Gathered(float(np.sqrt(max(2 * power + chance, 0.0))), widening, half, floor))
    return answer
