"""The spectrum of what the lines leave, band by band, the bins beside a line left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

BANDS_PER_OCTAVE = 8
_LOWEST = 1.2  # [Hz]
_HIGHEST_SHARE = 0.46  # of the sample rate: nearer to half of it converters and filters differ
_BESIDE_A_LINE = 2.0  # bins either way that a line fitted under a Hann window empties
_NARROW, _NARROWEST = 0.03, 1.0  # of a notch's frequency, and two bins of a stretch of 2 s [Hz]: bands around it
_FLANK = 4  # of them to each side of its middle
_INDEPENDENT = 0.7  # share of neighbouring bins that a Hann window leaves independent


@dataclass(frozen=True)
class Bands:
    """Middle [Hz], mean density (NaN where lines leave no bin), independent values and width [Hz] of each band."""

    middle: Floats
    power: Floats
    count: Floats
    width: Floats


@dataclass(frozen=True)
class Spectrum:
    """One stretch: density of each bin, and which bins count."""

    density: Floats
    counts: NDArray[np.bool_]


def spectrum(rest: Floats, rate: float, lines: Sequence[float], *, smeared: float = 0.0) -> Spectrum:
    """Return the one-sided density of ``rest`` under a Hann window; bins beside ``lines`` [Hz] do not count.

    ``smeared`` is the share of its frequency over which an angle that was not measured spreads a line.
    """
    window = np.hanning(rest.size)
    density = 2 * np.abs(np.fft.rfft(rest * window)) ** 2 / ((window**2).sum() * rate)
    counts = np.ones(density.size, dtype=bool)
    for line in lines:
        at = line * rest.size / rate
        beside = max(_BESIDE_A_LINE, smeared * at)
        counts[max(int(np.ceil(at - beside)), 0) : int(np.floor(at + beside)) + 1] = False
    return Spectrum(np.asarray(density), counts)


def band_edges(rate: float, notches: Sequence[float] = ()) -> Floats:
    """Return the edges of the bands [Hz]: eight to the octave, and narrow ones around the middle of each notch."""
    octaves = np.log2(_HIGHEST_SHARE * rate / _LOWEST)
    edges = np.asarray(_LOWEST * 2 ** (np.arange(int(octaves * BANDS_PER_OCTAVE) + 1) / BANDS_PER_OCTAVE))
    for notch in notches:
        narrow = max(_NARROW * notch, _NARROWEST)
        finer = notch + narrow * (np.arange(-_FLANK, _FLANK) + 0.5)
        edges = np.sort(np.append(edges[np.abs(edges - notch) > narrow * (_FLANK + 0.5)], finer))
    return edges


def no_bands(rate: float) -> Bands:
    """Return the bands of a run whose speed moves: places without densities."""
    edges = band_edges(rate)
    return Bands(np.sqrt(edges[:-1] * edges[1:]), np.array([]), np.array([]), np.diff(edges))


def bands(spectra: Sequence[Spectrum], rate: float, notches: Sequence[float] = ()) -> Bands:
    """Return the mean of several stretches in bands that hold at least one bin; ``notches`` as in ``band_edges``."""
    edges = band_edges(rate, notches)
    size = min(each.density.size for each in spectra)
    density = np.array([each.density[:size] for each in spectra])
    counts = np.array([each.counts[:size] for each in spectra])
    frequency = np.linspace(0.0, 0.5 * rate, size)
    index = np.searchsorted(edges, frequency, side="right") - 1
    inside = (index >= 0) & (index < edges.size - 1)

    def summed(values: Floats) -> Floats:
        return np.bincount(index[inside], weights=values[inside], minlength=edges.size - 1).astype(np.float64)

    bins = summed(np.ones(size))
    seen = bins > 0
    used = summed(counts.sum(axis=0).astype(np.float64))[seen]
    total = summed((density * counts).sum(axis=0))[seen]
    middle = np.exp(summed(np.log(np.maximum(frequency, 1e-9)))[seen] / bins[seen])
    power = np.where(used > 0, total / np.maximum(used, 1.0), np.nan)
    return Bands(middle, power, np.maximum(_INDEPENDENT * used, 1e-3), bins[seen] * (0.5 * rate / (size - 1)))
