"""Narrow notches that all steady runs have at one frequency: an inertia on a spring takes up what would turn the shaft.

Eighths of an octave blur them: a light branch that hardly damps empties two hundredths of its frequency, and no more.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.signal import welch

from torquerig.diagnosis.looking.observed import Observed

Floats = NDArray[np.float64]

# [Hz]: slower ones are the speed loop's; above, pulses of a load that are all of one length leave gaps of their own,
# 1.5 over their length, which in 34 of 900 rigs lay between 115 and 150 Hz
_LOWEST, _HIGHEST = 12.0, 100.0
_NARROW = 0.01  # of its frequency either way, one bin at least
_BESIDE, _BEYOND = 0.06, 0.17  # of its frequency: where the density on both sides is taken
# log of the density over the lower of both sides, in every steady run: of 900 rigs eight went deeper, each with a mode
_DEEP = -1.5
_MEDIAN = float(np.log(2))  # of an exponential variable of mean 1
_FEWEST, _FEWEST_BINS = 2, 3  # steady runs; bins on a side


def notches(runs: Sequence[Observed]) -> tuple[float, ...]:
    """Return the frequencies [Hz] of the notches in the spectra of what fits may see of the steady runs.

    None where fewer than two are steady. Density as in Welch 1967, IEEE Trans. Audio Electroacoust. 15(2).
    """
    steady = [run for run in runs if run.steady and not run.rebuilt]
    if len(steady) < _FEWEST:
        return ()
    seconds = min((stretch.stop - stretch.start) / run.rate for run in steady for stretch in run.stretches)
    middles = np.arange(np.ceil(_LOWEST * seconds), _HIGHEST * seconds) / seconds
    shallowest = np.max([_depth(run, seconds, middles) for run in steady], axis=0)
    found = list[float]()
    while shallowest.size and shallowest.min() < _DEEP:
        deepest = float(middles[np.argmin(shallowest)])
        found.append(deepest)
        shallowest[np.abs(middles / deepest - 1) < _BEYOND] = np.inf
    return tuple(sorted(found))


def _depth(run: Observed, seconds: float, middles: Floats) -> Floats:
    """Return the logarithm of the density around each frequency, over the lower median of both its sides.

    Infinite where a side holds too few bins to tell.
    """
    at, density = welch(run.torque[run.seen], run.rate, nperseg=round(seconds * run.rate), noverlap=0)
    step = 1 / seconds

    def depth(middle: float) -> float:
        away = at / middle - 1
        sides = (density[(away > _BESIDE) & (away < _BEYOND)], density[(away < -_BESIDE) & (away > -_BEYOND)])
        if any(side.size < _FEWEST_BINS for side in sides):
            return np.inf
        beside = min(float(np.median(side)) for side in sides) / _MEDIAN
        near = float(density[np.abs(at - middle) < max(_NARROW * middle, step) + 0.5 * step].mean())
        return float(np.log(near / beside)) if near > 0 and beside > 0 else np.inf

    return np.array([depth(middle) for middle in middles.tolist()])
