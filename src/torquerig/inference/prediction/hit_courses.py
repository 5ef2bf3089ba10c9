"""How the density of a random load changes where its hits have another course than stated.

No scenario states how the torque of a hit rises and falls. A pulse of finite length has zeros in its spectrum, which
look like the antiresonance of a mode. A process that declares densities with hits of other courses
(``shaped_densities``) makes them alternatives of the model.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.bands import Bands
from torquerig.rig.terms import Load

Floats = NDArray[np.float64]

COURSES = 2  # that a process declares
_POINTS = 16  # of a band, over which a density is averaged: zeros are narrower


def hit_courses(loads: Sequence[Load], bands: Bands) -> Floats:
    """Return the logarithm of the density with each course over that of ``density`` [1], shape (courses, bands)."""
    at = bands.low + (bands.high - bands.low) * (np.arange(_POINTS)[:, None] + 0.5) / _POINTS
    stated, other = np.zeros(bands.low.size), np.zeros((COURSES, bands.low.size))
    for load in loads:
        density, shaped = (getattr(load.process, name, None) for name in ("density", "shaped_densities"))
        if density is not None:
            own = density(at).mean(axis=0)
            stated += own
            other += own if shaped is None else shaped(at).mean(axis=1)
    known = stated > 0
    return np.asarray(np.log(np.where(known, other, 1.0) / np.where(known, stated, 1.0)))
