"""What all lines of a run at one speed have in common from block to block: the gain of the reading.

A zero that moves leaves the lines as they are, a gain that moves takes all of them along. At one mean torque nothing
else separates the two. With P_bl the power of line l in block b, ``d_bl = ln P_bl - mean_b ln P_bl`` have the common
part ``y_b = sum_l w_l d_bl / sum_l w_l``. The weight of a line is the inverse of its variance: that of a phasor in
noise, ``(2 S N + N^2) / P^2``, or what its own deviations from the common part show, so that a line which beats or
fades has none. Orthonormal contrasts of the blocks (Helmert) are independent.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import helmert

if TYPE_CHECKING:
    from torquerig.inference.features.run_features import RunFeatures

Floats = NDArray[np.float64]

FEWEST_LINES = 3  # of two nobody knows which one changes
_LEAST = 0.01  # [1] of the amplitude of a line from block to block: no rig is steadier by itself
_COMMON = 0.01  # [1] the same of all lines together: a mean load and a speed wander
_ITERATIONS = 6  # of weights and common part, each of which follows the other
FEWEST_BLOCKS = 2
_CLEAR = 4.0  # [1] times the noise: a weaker line has a logarithm that is far from normal
_NOTHING = 1e-300


@dataclass(frozen=True, eq=False)
class CommonChange:
    """Of one segment.

    Parameters
    ----------
    segment : int
    value : ndarray, shape (blocks - 1,)
        Contrasts of the common part of the logarithms of the powers [1].
    sd : float
        Standard deviation of each [1].
    contrasts : ndarray, shape (blocks - 1, blocks)
        Orthonormal, by the blocks of the segment.
    """

    segment: int
    value: Floats
    sd: float
    contrasts: Floats


def common_changes(seen: RunFeatures) -> tuple[CommonChange, ...]:
    """Return what the lines of each segment of a run at one speed have in common; none where too few are clear."""
    if not seen.run.is_steady:
        return ()
    found = [_of_segment(seen, at) for at in range(len(seen.segments))]
    return tuple(each for each in found if each is not None)


def _of_segment(seen: RunFeatures, at: int) -> CommonChange | None:
    segment = seen.segments[at]
    power, noise = segment.block_lines, segment.line_noise_bandwidth * _floor(seen, at)
    blocks = len(segment.blocks)
    with np.errstate(invalid="ignore"):
        clear = np.isfinite(power).all(axis=0) & np.isfinite(noise) & (power.min(axis=0) > _CLEAR * noise)
    if blocks < FEWEST_BLOCKS or int(clear.sum()) < FEWEST_LINES:
        return None
    logs = np.log(np.maximum(power[:, clear], _NOTHING))
    logs = logs - logs.mean(axis=0)
    share = noise[clear] / power[:, clear].mean(axis=0)
    own = 2 * share * (1 - share) + share**2 + (2 * _LEAST) ** 2
    common = np.median(logs, axis=1)
    for _ in range(_ITERATIONS):
        scatter = np.square(logs - common[:, None]).sum(axis=0) / (blocks - 1)
        weight = 1 / np.maximum(own, scatter)
        common = logs @ weight / weight.sum()
    contrasts = np.asarray(helmert(blocks), dtype=np.float64)
    return CommonChange(at, contrasts @ common, float(np.sqrt(1 / weight.sum() + (2 * _COMMON) ** 2)), contrasts)


def _floor(seen: RunFeatures, at: int) -> Floats:
    """Return the measured density between the lines at each line of a segment [(N m)^2/Hz]; NaN without any band."""
    density, middle = seen.band_power[at], seen.bands.middle
    shown = np.isfinite(density) & (density > 0)
    if not shown.any():
        return np.full(seen.line_frequency.shape[1], np.nan)
    place = np.log(np.maximum(seen.line_frequency[at], seen.bands.low[0]))
    return np.asarray(np.exp(np.interp(place, np.log(middle[shown]), np.log(density[shown]))))
