"""Whether a line follows the shaft or has a fixed frequency: on which of the two axes it is narrower."""

from __future__ import annotations

from dataclasses import dataclass
from math import log10
from typing import TYPE_CHECKING, Literal

import numpy as np

from torquerig.orders.analysis.peaks import NEIGHBOURS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Complexes = NDArray[np.complex128]

Domain = Literal["order", "frequency", "either"]
DECIDED = 4.0  # [dB] least contrast; the constant part of a ramp alone gives either kind of line 2.3 dB
_HALF_BAND = NEIGHBOURS  # bins kept on either side of a line
_BEST = 2  # bins on either side of the highest that count as the line
_STEEPEST, _MOST_POINTS = 30.0, 2**19


@dataclass(frozen=True)
class LineDomain:
    """How narrow a line is on each axis.

    Parameters
    ----------
    by_order, by_frequency : float
        Share of the line's power in the best five bins, over the angle and over time [1].
    """

    by_order: float
    by_frequency: float

    @property
    def contrast_dB(self) -> float:  # noqa: N802  (decibel is written dB)
        """The ratio of the two shares, over the angle to over time [dB]; negative for a fixed frequency."""
        return 10 * log10(max(self.by_order, 1e-12) / max(self.by_frequency, 1e-12))

    @property
    def domain(self) -> Domain:
        """``order``, ``frequency``, or ``either`` where the speed changes too little to decide."""
        if abs(self.contrast_dB) < DECIDED:
            return "either"
        return "order" if self.contrast_dB > 0 else "frequency"


class DomainTest:
    """Determines the domain of lines of one signal; holds the two transforms that all tests share.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        At equal steps of time.
    turns : ndarray, shape (samples,)
        Of the output shaft, rising.
    even : ndarray, shape (steps,)
        The same signal at equal steps of the turns.
    """

    def __init__(self, values: Floats, turns: Floats, even: Floats) -> None:
        self._share_turned = (turns - turns[0]) / float(turns[-1] - turns[0])
        self._share_passed = np.arange(turns.size) / turns.size
        self._turns = float(turns[-1] - turns[0])
        self._over_time = np.fft.rfft(values - values.mean())
        self._over_angle = np.fft.rfft(even - even.mean())

    def of_order(self, order: float) -> LineDomain:
        """Return how narrow the content within a dozen bins of an order [1/rev] is on each axis."""
        by_order, by_time = _shares(self._over_angle, order * self._turns, self._share_passed, self._share_turned)
        return LineDomain(by_order, by_time)

    def of_periods(self, periods: float) -> LineDomain:
        """Return the same for a fixed frequency, given in periods over the whole recording."""
        by_time, by_order = _shares(self._over_time, periods, self._share_turned, self._share_passed)
        return LineDomain(by_order, by_time)


def _shares(spectrum: Complexes, periods: float, other: Floats, along: Floats) -> tuple[float, float]:
    """Return the shares of power in the best bins, on the axis of ``spectrum`` and on the other axis.

    ``along`` and ``other`` are the shares of the two axes that have passed at each sample. The line is the sum of its
    few bins, resampled at equal steps of the other axis.
    """
    centre = round(periods)
    low, high = max(centre - _HALF_BAND, 1), min(centre + _HALF_BAND + 1, spectrum.size)
    bins = spectrum[low:high]
    steepest = float(np.max(np.diff(along)) / max(float(np.mean(np.diff(other))), 1e-300))
    slope = min(steepest, _STEEPEST) + 1
    points = min(int(4 * (centre + _HALF_BAND) * slope) + 256, _MOST_POINTS)
    at = np.interp(np.linspace(0, 1, points, endpoint=False), other, along)
    turned = np.exp(2j * np.pi * at)
    line = np.full(points, bins[-1], dtype=np.complex128)
    for one in bins[-2::-1]:
        line *= turned
        line += one
    line *= np.exp(2j * np.pi * low * at)
    return _concentration(bins), _concentration(np.fft.fft(line))


def _concentration(amplitudes: Complexes) -> float:
    """Return the largest share of the power in a few adjacent bins [1]."""
    power = np.abs(amplitudes) ** 2
    whole = float(power.sum())
    if not whole > 0:
        return 0.0
    sums = np.convolve(power, np.ones(2 * _BEST + 1), mode="same")
    return min(float(sums.max()) / whole, 1.0)
