"""Peaks of a spectrum above the local noise floor."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.analysis.order_spectrum import LineSpectrum

    Floats = NDArray[np.float64]

_BINS = 48  # bins whose median is one point of the noise floor, which is linear between the points
_APART = 4  # [bins] least distance of two peaks
_FALSE_ALARMS = 1e-3  # expected number of noise peaks above the threshold in a whole spectrum
NEIGHBOURS = 12  # [bins] within which a weaker peak counts as a skirt or sideband of a larger one
_WEAKER = 10 ** (-12 / 20)  # [1] amplitude of such a peak relative to the larger one, at most


@dataclass(frozen=True)
class Peak:
    """A peak at ``place``, its amplitude on the bin, and its level above the mean noise power [dB]."""

    place: float
    amplitude: float
    above_dB: float  # noqa: N815  (decibel is written dB)


def floor_of(amplitudes: Floats) -> Floats:
    """Return the rms amplitude of the noise at each bin, shape (bins,), from medians, which lines hardly change."""
    power = amplitudes**2
    count = max(power.size // _BINS, 1)
    pieces = np.array_split(power, count)
    centres = np.cumsum([piece.size for piece in pieces]) - np.array([piece.size / 2 for piece in pieces])
    # the median of a chi-square with two degrees of freedom is ln 2 of its mean
    medians = np.array([np.median(piece) for piece in pieces]) / log(2)
    return np.sqrt(np.interp(np.arange(power.size), centres, medians)) + 1e-300


def peaks_of(
    spectrum: LineSpectrum, *, lowest: float, expected: Sequence[float] = (), most: int = 60
) -> tuple[Peak, ...]:
    """Return the significant peaks of a spectrum, the highest above the noise floor first.

    Parameters
    ----------
    spectrum : LineSpectrum
    lowest : float
        Lowest place of a peak, in the unit of the places.
    expected : sequence of float
        Places where a line is expected, such as multiples of the mains; the threshold is lower there.
    most : int
        Largest number of peaks.

    Notes
    -----
    The threshold is the power that one bin in a thousand spectra of exponential noise reaches: ln(bins / 0.001) times
    the floor. At the expected places only these bins are counted, so that the lower threshold gives no more false
    alarms. A peak 12 dB or more below another one within a dozen bins is rejected: an amplitude that changes over a
    ramp causes such skirts.
    """
    height = spectrum.amplitudes / floor_of(spectrum.amplitudes)
    limit = _limits(spectrum, expected)
    inner = np.flatnonzero(
        (height[1:-1] > limit[1:-1]) & (spectrum.amplitudes[1:-1] >= spectrum.amplitudes[:-2])
        & (spectrum.amplitudes[1:-1] > spectrum.amplitudes[2:]) & (spectrum.places[1:-1] >= lowest)
    ) + 1  # fmt: skip
    kept: list[int] = []
    for one in inner[np.argsort(-spectrum.amplitudes[inner], kind="stable")]:
        if not any(_hidden(spectrum.amplitudes, int(one), other) for other in kept):
            kept.append(int(one))
    kept.sort(key=lambda one: -height[one])
    return tuple(
        Peak(_between(spectrum, one), float(spectrum.amplitudes[one]), float(20 * np.log10(height[one])))
        for one in kept[:most]
    )


def _limits(spectrum: LineSpectrum, expected: Sequence[float]) -> Floats:
    """Return the threshold at each bin, relative to the noise floor [1]."""
    bins = np.round(np.array(expected, dtype=np.float64) / spectrum.width).astype(np.int64)
    near = np.unique(bins[:, None] + np.array([-1, 0, 1])[None, :])
    near = near[(near >= 0) & (near < spectrum.places.size)]
    limits = np.full(spectrum.places.size, np.sqrt(log(spectrum.places.size / _FALSE_ALARMS)))
    if near.size:
        limits[near] = min(float(np.sqrt(log(near.size / _FALSE_ALARMS))), float(limits[0]))
    return limits


def _hidden(amplitudes: Floats, one: int, larger: int) -> bool:
    distance = abs(one - larger)
    return distance < _APART or (distance <= NEIGHBOURS and amplitudes[one] < _WEAKER * amplitudes[larger])


def _between(spectrum: LineSpectrum, one: int) -> float:
    """Return the place of a line between two bins, from the ratio of its two highest bins with a Hann window."""
    left, middle, right = spectrum.amplitudes[one - 1 : one + 2]
    side, ratio = (1, right / middle) if right > left else (-1, left / middle)
    # Hann window: with the ratio r of neighbours the line is (2 r - 1) / (r + 1) bins from the higher bin
    return float(spectrum.places[one] + side * spectrum.width * min(max((2 * ratio - 1) / (ratio + 1), 0.0), 0.5))
