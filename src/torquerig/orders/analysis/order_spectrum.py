"""Amplitudes over the order of the output shaft, and the amplitude of one line exactly at its order."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.analysis.angle_resampling import OverAngle
from torquerig.recordings.spectrum import hann_spectrum

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class LineSpectrum:
    """A one-sided amplitude spectrum.

    Parameters
    ----------
    places : ndarray, shape (bins,)
        Orders of the output shaft [1/rev], or frequencies [Hz].
    amplitudes : ndarray, shape (bins,)
        Zero to peak [N m], with a Hann window.
    """

    places: Floats
    amplitudes: Floats

    @property
    def width(self) -> float:
        """The bin width in the unit of ``places``."""
        return float(self.places[1])


def order_spectrum(signal: OverAngle, *, highest: float | None = None) -> LineSpectrum:
    """Return the amplitudes over the order of the output shaft, up to ``highest`` [1/rev].

    A line on a bin gives its amplitude, averaged over the angle; between two bins it gives 85 % or more.
    """
    orders, amplitudes = hann_spectrum(signal.values, signal.per_turn)
    kept = orders <= (highest or np.inf)
    return LineSpectrum(orders[kept], amplitudes[kept])


def frequency_spectrum(values: Floats, rate: float, *, highest: float | None = None) -> LineSpectrum:
    """Return the amplitudes over frequency up to ``highest`` [Hz], with the same window."""
    frequencies, amplitudes = hann_spectrum(values, rate)
    kept = frequencies <= (highest or np.inf)
    return LineSpectrum(frequencies[kept], amplitudes[kept])


def line_amplitude(values: Floats, turns: Floats, order: float) -> float:
    """Return the zero-to-peak amplitude of the sine of one order of the turned angle, in the unit of ``values``.

    ``|2 sum w x exp(-2 pi i n turns) dturns| / sum w dturns`` with a Hann window w over the turns, without resampling
    and so without interpolation error. Lines three bins of 1 / turns away or more change it by less than 1 %.

    Parameters
    ----------
    values : ndarray, shape (samples,)
    turns : ndarray, shape (samples,)
        Rising; for a fixed frequency the time [s], with ``order`` the frequency [Hz].
    order : float
        Periods per turn.
    """
    share = (turns - turns[0]) / (turns[-1] - turns[0])
    weight = np.sin(np.pi * share) ** 2 * np.gradient(turns)
    weight /= weight.sum()
    mean = weight @ values
    return float(2 * abs(np.sum(weight * (values - mean) * np.exp(-2j * np.pi * order * turns))))
