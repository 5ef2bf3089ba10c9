"""Gain of the random load: what nobody knows of its spectrum, its strength and its dependence on the speed.

The density that random loads make is multiplied by ``exp(sum_k u_k h_k(ln f) + v_r + e ln(w / w_r))``: h_k triangles
over two octaves that add up to 1, u_k normal with ``SPECTRUM_SD``, the same in all runs; v_r of one run, normal with
``RUN_SD``; e the same in all runs, normal with ``EXPONENT_SD``, w the speed of a segment and w_r the largest one of its
run. A model discrepancy in the sense of Kennedy & O'Hagan 2001 (J. R. Stat. Soc. B 63), written as parameters: their
prior is its covariance.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.expected_run import ExpectedRun

Floats = NDArray[np.float64]

SPECTRUM_SD = 0.3  # [1] of the logarithm of the density: no load is known to better than 1.3 dB per octave pair
RUN_SD = 0.4  # [1] of the logarithm of the density in one run
EXPONENT_SD = 2.0  # [1] of the exponent: turbulence goes with the fourth power of the speed, hits of grains with none
_OCTAVES = 2.0  # between two neighbouring triangles
_SLOWEST = 0.02  # [1] of the largest speed: slower than this no power law holds
_LOWEST, _HIGHEST = 1.0, 16_384.0  # [Hz] middles of the first and of the last triangle


def _triangles_count() -> int:
    return int(np.ceil(np.log2(_HIGHEST / _LOWEST) / _OCTAVES)) + 1


def gain_shapes(seen: RunFeatures, *, run: int, runs: int) -> Floats:
    """Return the logarithm of the density per standard deviation of each gain, shape (segments, bands, gains)."""
    bands = seen.bands
    at = np.log2(bands.middle / _LOWEST) / _OCTAVES
    spectrum = SPECTRUM_SD * np.maximum(0.0, 1.0 - np.abs(at[:, None] - np.arange(_triangles_count())[None]))
    own = np.zeros(runs)
    own[run] = RUN_SD
    speed = np.abs(seen.speed)
    slower = np.log(np.maximum(speed / max(float(speed.max()), 1e-12), _SLOWEST))
    shape = (speed.size, at.size)
    return np.concatenate(
        [
            np.broadcast_to(spectrum, (*shape, spectrum.shape[1])),
            np.broadcast_to(own, (*shape, runs)),
            np.broadcast_to(EXPONENT_SD * slower[:, None, None], (*shape, 1)),
        ],
        axis=2,
    )


def with_gains(model: ExpectedRun, shape: Floats, gains: Floats) -> ExpectedRun:
    """Return the expectation with the random load's density multiplied; ``gains`` in standard deviations."""
    factor = np.exp(shape @ gains)
    density = model.density * (1 + model.load_share * (factor - 1))
    return replace(model, density=density, load_share=model.load_share * factor * model.density / density)
