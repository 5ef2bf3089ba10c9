"""Whether a line belongs to the shaft or to the clock: which of the two axes gathers it more."""

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
DECIDED = 4.0  # [dB]; the part of a ramp that holds its speed shows a line of either kind on both axes, 2.3 dB apart
_HALF_BAND = NEIGHBOURS  # bins kept on either side of a line
_BEST = 2  # bins on either side of the highest that count as one place
_STEEPEST, _MOST_POINTS = 30.0, 2**19


@dataclass(frozen=True)
class LineDomain:
    """How far a line gathers on each axis.

    Parameters
    ----------
    by_order, by_frequency : float
        Share of the line's power in the best five bins, over the angle and over time [1].
    """

    by_order: float
    by_frequency: float

    @property
    def contrast_dB(self) -> float:  # noqa: N802  (decibel is written dB)
        """By how much the angle gathers the line more than time does [dB]; negative for a fixed frequency."""
        return 10 * log10(max(self.by_order, 1e-12) / max(self.by_frequency, 1e-12))

    @property
    def domain(self) -> Domain:
        """``order``, ``frequency``, or ``either`` where the speed changes too little to tell."""
        if abs(self.contrast_dB) < DECIDED:
            return "either"
        return "order" if self.contrast_dB > 0 else "frequency"


class DomainTest:
    """Tells lines of one signal by their domain; holds the two transforms that all tests share.

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
        """Return how far what stands within a dozen bins of an order [1/rev] gathers on each axis."""
        own, other = _shares(self._over_angle, order * self._turns, self._share_passed, self._share_turned)
        return LineDomain(own, other)

    def of_periods(self, periods: float) -> LineDomain:
        """Return the same for a fixed frequency, counted in periods over the whole recording."""
        own, other = _shares(self._over_time, periods, self._share_turned, self._share_passed)
        return LineDomain(other, own)


def _shares(spectrum: Complexes, periods: float, other: Floats, own: Floats) -> tuple[float, float]:
    """Return the shares of the best place on a line's own axis and on the other one.

    ``other`` and ``own`` are what share of either axis has passed at each sample. The line is the sum of its few bins,
    taken at equal steps of the other axis.
    """
    centre = round(periods)
    low, high = max(centre - _HALF_BAND, 1), min(centre + _HALF_BAND + 1, spectrum.size)
    bins = spectrum[low:high]
    steepest = float(np.max(np.diff(own)) / max(float(np.mean(np.diff(other))), 1e-300))
    slope = min(steepest, _STEEPEST) + 1
    points = min(int(4 * (centre + _HALF_BAND) * slope) + 256, _MOST_POINTS)
    at = np.interp(np.linspace(0, 1, points, endpoint=False), other, own)
    turned = np.exp(2j * np.pi * at)
    line = np.full(points, bins[-1], dtype=np.complex128)
    for one in bins[-2::-1]:
        line *= turned
        line += one
    line *= np.exp(2j * np.pi * low * at)
    return _gathered(bins), _gathered(np.fft.fft(line))


def _gathered(amplitudes: Complexes) -> float:
    """Share of the power in the best few bins that lie side by side."""
    power = np.abs(amplitudes) ** 2
    whole = float(power.sum())
    if not whole > 0:
        return 0.0
    sums = np.convolve(power, np.ones(2 * _BEST + 1), mode="same")
    return min(float(sums.max()) / whole, 1.0)
