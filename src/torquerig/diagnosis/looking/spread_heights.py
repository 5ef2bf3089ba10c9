"""By how much the power of a hertz or two stands above that on both sides: between a peak and a band of the spectrum.

The median of the bins is taken, so that a line in one of them does not count; its logarithm scatters by a known amount
where the bins are those of noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.bands import Spectrum, spectrum
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import beside_lines
from torquerig.inference.places import Place

Floats = NDArray[np.float64]

LOWEST, HIGHEST = 5.0, 1000.0  # [Hz]
STEP = 0.125  # [Hz] of the grid on which runs are put together
_TOP = 0.4  # of the sample rate
_SIDES, _FEWEST = 4, 24  # widths, and bins at least, that the floor on either side is taken from
_FEWEST_WITHIN = 4  # bins
_BINS_A_SPREAD = 3.1  # over the bins: variance of the logarithm of a median of exponential variates, Hann window


@dataclass(frozen=True)
class SpreadHeights:
    """Of one run, at each frequency [Hz] beside its lines: logarithm of the power over both sides, and in spreads."""

    run: Observed
    frequency: Floats
    height: Floats
    spreads: Floats

    def at(self, frequency: Floats) -> tuple[Floats, Floats]:
        """Return spreads and height nearest to each frequency [Hz]; 0 where none is looked at within two steps."""
        after = np.clip(np.searchsorted(self.frequency, frequency), 1, self.frequency.size - 1)
        nearer = np.abs(self.frequency[after - 1] - frequency) < np.abs(self.frequency[after] - frequency)
        index = after - nearer
        there = np.abs(self.frequency[index] - frequency) < 2 * STEP
        return np.where(there, self.spreads[index], 0.0), np.where(there, self.height[index], 0.0)


def spectrum_beside(run: Observed, known: Sequence[Place]) -> Spectrum:
    """Return the spectrum of what fits may see of a steady run, the lines at ``known`` taken out and left out."""
    lines = [place.frequency(run.mean_speed) for place in known]
    return spectrum(beside_lines(run, known), run.rate, lines, smeared=run.smearing)


def spread_heights(run: Observed, beside: Spectrum, width: float) -> SpreadHeights | None:
    """Return how high a run stands out over a ``width`` [Hz]; None where lines leave too little of it."""
    from scipy.ndimage import median_filter

    step = 0.5 * run.rate / (beside.density.size - 1)
    frequency = np.arange(beside.density.size) * step
    counts = beside.counts & (frequency >= LOWEST) & (frequency < min(HIGHEST, _TOP * run.rate))
    frequency, power = frequency[counts], beside.density[counts]
    bins = max(_FEWEST_WITHIN, round(width / step))
    side = max(_FEWEST, _SIDES * bins)
    away = side // 2 + bins
    if power.size < 4 * (away + side):
        return None
    middle, wide = (np.maximum(median_filter(power, size=size, mode="nearest"), 1e-300) for size in (bins, side))
    inside = slice(away + side // 2, -(away + side // 2))
    floor = np.maximum(np.roll(wide, away), np.roll(wide, -away))[inside]
    height = np.log(middle[inside] / floor)
    return SpreadHeights(run, np.asarray(frequency[inside]), height, height / np.sqrt(_BINS_A_SPREAD / bins))
