"""Covariance of the levels of a run: what slow loads leave in the means of its parts."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures

Floats = NDArray[np.float64]


def covariance(seen: RunFeatures, density: Floats) -> Floats:
    """Return the covariance [(N m)^2] of the levels under torque of a one-sided density, shape (levels, levels).

    ``C_ij = integral S(f) sinc(f T_i) sinc(f T_j) cos(2 pi f (t_i - t_j)) df``, T the lengths and t the middles of the
    parts, S at ``seen.level_grid``. Source: mean of a stationary process over a window, any text on spectral analysis
    (Priestley 1981, 5.3).
    """
    return seen.kept.get("covariance", density.tobytes(), lambda: _covariance(seen, density))


def _covariance(seen: RunFeatures, density: Floats) -> Floats:
    passed = seen.level_passed
    weighted = np.concatenate([passed.real, passed.imag], axis=1)
    weighted *= np.tile(np.sqrt(density * np.gradient(seen.level_grid)), 2)
    return np.asarray(weighted @ weighted.T)
