"""Gain of the random load: what nobody knows of its spectrum, its strength and its dependence on the speed.

The density that random loads make is multiplied by ``exp(sum_k u_k h_k(ln f) - sum_k c_k ln(1 + (f / f_k)^4) + v_r +
e ln(w / w_r))``: h_k triangles over two octaves that add up to 1, u_k normal with ``SPECTRUM_SD``; f_k an octave apart,
c_k normal with ``CORNER_SD``. A load that ends at f_k as a second-order low-pass has c_k = 1. A sensor of this
cutoff does the same, but to lines too. u_k and c_k are the same in all runs. v_r is that of one run, normal with
``RUN_SD``; e the same in all runs, normal with ``EXPONENT_SD``, w the speed of a segment and w_r the largest one of its
run. The variance that slow loads leave in the levels is multiplied by ``exp(v_r + s)``, s the same in all runs, normal
with ``SLOW_SD``: what a load does in a second says little of what it does in a minute. A model discrepancy in the sense
of Kennedy & O'Hagan 2001 (J. R. Stat. Soc. B 63), written as parameters: their prior is its covariance.

Hits of another course than the model's (``prediction/hit_courses.py``) change the density by ``exp(sum_j b_j r_j(f))``,
r_j the logarithm of the density with the course j over that of the model: b_j = 1 is this course, 0 the model's. b_j is
normal with ``COURSE_SD``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.prediction.expected_run import ExpectedRun
from torquerig.inference.prediction.hit_courses import COURSES

Floats = NDArray[np.float64]

SPECTRUM_SD = 0.3  # [1] of the logarithm of the density: no load is known to better than 1.3 dB per octave pair
CORNER_SD = 0.5  # [1] of the power of a second-order low-pass: above a corner a hit or a wake falls by f^2 more or less
RUN_SD = 0.4  # [1] of the logarithm of the density in one run
SLOW_SD = 1.0  # [1] of the logarithm of the variance of slow loads
EXPONENT_SD = 2.0  # [1] of the exponent: turbulence goes with the fourth power of the speed, hits of grains with none
COURSE_SD = 1.0  # [1] either course is as likely as the model's
_OCTAVES = 2.0  # between two neighbouring triangles
_SLOWEST = 0.02  # [1] of the largest speed: slower than this no power law holds
_TRIANGLES = 8  # the last one has its middle at half the largest sample rate


@dataclass(frozen=True, eq=False)
class GainShapes:
    """Logarithm of densities per standard deviation of each gain.

    Parameters
    ----------
    bands : ndarray, shape (segments, bands, gains)
    levels : ndarray, shape (gains,)
        Of the variance of the levels.
    courses : ndarray, shape (courses, gains)
        Shares of other courses of hits.
    """

    bands: Floats
    levels: Floats
    courses: Floats

    @property
    def count(self) -> int:
        """Number of gains."""
        return self.levels.size

    def acts(self, gain: int) -> bool:
        """Return whether a gain changes anything."""
        return bool(self.bands[:, :, gain].any() or self.levels[gain] or self.courses[:, gain].any())


def gain_shapes(seen: RunFeatures, *, run: int, runs: Sequence[MeasuredRun]) -> GainShapes:
    """Return how the gains act on the features of ``runs[run]``."""
    bands = seen.bands
    below = np.log2(0.5 * max(each.rate for each in runs) / bands.middle) / _OCTAVES
    at = np.minimum(below, _TRIANGLES - 1)  # slower still as there
    spectrum = SPECTRUM_SD * np.maximum(0.0, 1.0 - np.abs(at[:, None] - np.arange(_TRIANGLES)[None]))
    corners = _corners(runs)
    falls = -CORNER_SD * np.log1p((bands.middle[:, None] / corners[None]) ** 4)
    spectrum = np.concatenate([spectrum, falls], axis=1)
    own = np.zeros(len(runs))
    own[run] = RUN_SD
    speed = np.abs(seen.speed)
    slower = np.log(np.maximum(speed / max(float(speed.max()), 1e-12), _SLOWEST))
    shape = (speed.size, at.size)
    columns = [
        np.broadcast_to(spectrum, (*shape, spectrum.shape[1])),
        np.zeros((*shape, COURSES)),
        np.broadcast_to(own, (*shape, len(runs))),
        np.broadcast_to(EXPONENT_SD * slower[:, None, None], (*shape, 1)),
        np.zeros((*shape, 1)),
    ]
    levels = np.concatenate([np.zeros(spectrum.shape[1] + COURSES), own, [0.0, SLOW_SD]])
    courses = COURSE_SD * np.eye(COURSES, levels.size, k=spectrum.shape[1])
    return GainShapes(np.concatenate(columns, axis=2), levels, courses)


def _corners(runs: Sequence[MeasuredRun]) -> Floats:
    """Return frequencies [Hz] an octave apart, from a quarter of the largest sample rate down to the slowest band."""
    compared = [each for each in runs if each.blocks]
    highest, slowest = 0.5 * max(each.rate for each in compared), min(each.slowest for each in compared)
    return np.asarray(highest * 0.5 ** np.arange(1, round(np.log2(highest / slowest))))


def with_gains(model: ExpectedRun, shape: GainShapes, gains: Floats) -> ExpectedRun:
    """Return the expectation with the random load's density multiplied; ``gains`` in standard deviations."""
    factor = np.exp(shape.bands @ gains + (shape.courses @ gains) @ model.hit_courses)
    slow = float(np.exp(shape.levels @ gains))
    density = model.density * (1 + model.load_share * (factor - 1))
    return replace(
        model, density=density, load_share=model.load_share * factor * model.density / density,
        level_covariance=model.level_covariance + (slow - 1) * model.slow_load, slow_load=slow * model.slow_load,
    )  # fmt: skip
