"""Narrow notches that all steady runs have at one frequency: an inertia on a spring takes up what would turn the shaft.

Eighths of an octave blur them: a light branch that hardly damps empties two hundredths of its frequency, and no more.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.signal import welch

from torquerig.diagnose.looking.observed import Observed

Floats = NDArray[np.float64]

# [Hz]: slower ones are the speed loop's; above, pulses of a load that are all of one length leave gaps of their own,
# 1.5 over their length, which in 34 of 900 rigs lay between 115 and 150 Hz
_LOWEST, _HIGHEST = 12.0, 100.0
_NARROW = 0.01  # of its frequency either way, one bin at least
_BESIDE, _BEYOND = 0.06, 0.17  # of its frequency: where the density on both sides is taken
# log of the density over the lower of both sides, in every steady run: of 900 rigs eight went deeper, each with a mode
_DEEP = -1.5
_MEDIAN = float(np.log(2))  # of an exponential variable of mean 1
_FEWEST = 2  # steady runs


def notches(runs: Sequence[Observed]) -> tuple[float, ...]:
    """Return the frequencies [Hz] of the notches in the spectra of what fits may see of the steady runs.

    None where fewer than two are steady. Density as in Welch 1967, IEEE Trans. Audio Electroacoust. 15(2).
    """
    steady = [run for run in runs if run.steady and not run.rebuilt]
    if len(steady) < _FEWEST:
        return ()
    shortest = min(stretch.stop - stretch.start for run in steady for stretch in run.stretches)
    at = np.asarray(np.fft.rfftfreq(shortest, 1 / steady[0].rate), dtype=np.float64)
    looked_at = np.flatnonzero((at > _LOWEST) & (at < _HIGHEST))
    shallowest = np.max([_depth(_density(run, shortest), at, looked_at) for run in steady], axis=0)
    found = list[float]()
    while shallowest.size and shallowest.min() < _DEEP:
        deepest = float(at[looked_at[np.argmin(shallowest)]])
        found.append(deepest)
        shallowest[np.abs(at[looked_at] / deepest - 1) < _BEYOND] = np.inf
    return tuple(sorted(found))


def _density(run: Observed, length: int) -> Floats:
    return np.asarray(welch(run.torque[run.seen], run.rate, nperseg=length, noverlap=0)[1])


def _depth(density: Floats, at: Floats, looked_at: NDArray[np.int64]) -> Floats:
    """Return the logarithm of the density around each bin, over the lower median of both its sides."""
    step = at[1] - at[0]

    def mean_near(middle: float) -> float:
        reach = max(_NARROW * middle, step)
        return float(density[np.abs(at - middle) < reach + 0.5 * step].mean())

    def lower_side(middle: float) -> float:
        away = at / middle - 1
        sides = (density[(away > _BESIDE) & (away < _BEYOND)], density[(away < -_BESIDE) & (away > -_BEYOND)])
        return min(float(np.median(side)) / _MEDIAN for side in sides)

    floor = np.finfo(float).tiny
    return np.array(
        [np.log(max(mean_near(one), floor) / max(lower_side(one), floor)) for one in at[looked_at].tolist()]
    )
