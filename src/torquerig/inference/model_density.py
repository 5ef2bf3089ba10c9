"""Spectral density that a fitted model expects without its lines, at any frequency."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.fit import Data, Fit
from torquerig.inference.load_spectrum import with_gains

Floats = NDArray[np.float64]


def model_densities(fit: Fit, data: Data) -> list[Callable[[Floats], Floats]]:
    """Return for each run the density [(N m)^2/Hz] as a function of frequency [Hz]."""
    return [_density(fit, data, row) for row in range(len(data.seen))]


def _density(fit: Fit, data: Data, row: int) -> Callable[[Floats], Floats]:
    model = with_gains(fit.expected[row], data.shapes[row], fit.gains)
    bands = data.seen[row].bands
    at, power = np.log(bands.middle), np.log(np.maximum(model.density.max(axis=0), 1e-300))

    def density(frequency: Floats) -> Floats:
        return np.asarray(np.exp(np.interp(np.log(np.maximum(frequency, bands.low[0])), at, power)))

    return density
