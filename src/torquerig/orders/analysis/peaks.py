"""What stands out of a spectrum: local peaks above the floor beside them."""

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

_BINS = 48  # a floor is the median of so many bins, and straight between them
_APART = 4  # [bins] of the larger of two peaks from the other
_FALSE_ALARMS = 1e-3  # peaks that noise alone is to show in a whole spectrum
NEIGHBOURS = 12  # [bins] in which a weaker peak is a skirt or a sideband of the larger one's changes
_WEAKER = 10 ** (-12 / 20)  # [1] than the larger one


@dataclass(frozen=True)
class Peak:
    """A peak at ``place``, its amplitude on the bin, and by how much its power exceeds the floor's mean [dB]."""

    place: float
    amplitude: float
    above_dB: float  # noqa: N815  (decibel is written dB)


def floor_of(amplitudes: Floats) -> Floats:
    """Return the rms amplitude of the noise at each bin, from medians that lines hardly move, shape (bins,)."""
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
    """Return the peaks of a spectrum that noise would hardly show, the most outstanding first.

    Parameters
    ----------
    spectrum : LineSpectrum
    lowest : float
        Peaks below this place are not looked for, in the unit of the places.
    expected : sequence of float
        Places where a line would be no surprise, such as multiples of the mains: there a weaker one counts.
    most : int

    Notes
    -----
    The threshold is the power that one bin in a thousand spectra of exponential noise reaches: ln(bins / 0.001) times
    the floor; at the expected places only their own bins count, so that a lower one gives no more false alarms. What is
    12 dB or more below a peak within a dozen bins is no peak of its own: an amplitude that changes
    over a ramp makes such skirts.
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
    """Return how far above the floor a peak must stand at each bin [1]."""
    bins = np.round(np.array(expected, dtype=np.float64) / spectrum.width).astype(np.int64)
    near = np.unique(bins[:, None] + np.array([-1, 0, 1])[None, :])
    near = near[(near >= 0) & (near < spectrum.places.size)]
    limits = np.full(spectrum.places.size, np.sqrt(log(spectrum.places.size / _FALSE_ALARMS)))
    if near.size:
        limits[near] = min(float(np.sqrt(log(near.size / _FALSE_ALARMS))), float(limits[0]))
    return limits


def _hidden(amplitudes: Floats, one: int, larger: int) -> bool:
    apart = abs(one - larger)
    return apart < _APART or (apart <= NEIGHBOURS and amplitudes[one] < _WEAKER * amplitudes[larger])


def _between(spectrum: LineSpectrum, one: int) -> float:
    """Where a line stands between two bins, from the ratio of its two highest bins through a Hann window."""
    left, middle, right = spectrum.amplitudes[one - 1 : one + 2]
    side, ratio = (1, right / middle) if right > left else (-1, left / middle)
    # sin x / x through a Hann window: the ratio r of neighbours puts the line (2 r - 1) / (r + 1) beyond the bin
    return float(spectrum.places[one] + side * spectrum.width * min(max((2 * ratio - 1) / (ratio + 1), 0.0), 0.5))
