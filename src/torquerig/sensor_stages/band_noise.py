"""Noise of a fixed band of frequencies."""

from __future__ import annotations

from dataclasses import dataclass
from math import log, pi, sqrt
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class BandNoise:
    """Gaussian noise of density ``D(f) = rms^2 / (f w sqrt(2 pi)) exp(-ln(f / f0)^2 / 2 w^2)``, added to the torque.

    Parameters
    ----------
    rms : float
        In the unit of the torque channel, >= 0.
    frequency : float
        f0 [Hz], > 0.
    width : float
        w, one sigma of the frequency's logarithm [1], > 0.

    Notes
    -----
    Source: the log-normal density, whose integral over all frequencies is rms^2; an empirical description.
    """

    rms: float
    frequency: float
    width: float

    def __post_init__(self) -> None:
        if not (self.rms >= 0 and self.frequency > 0 and self.width > 0):
            raise InputError(
                f"a hump of {self.rms} at {self.frequency} Hz, {self.width} wide cannot be; "
                "write 0 or more, and more than 0 for frequency and width"
            )

    def density(self, frequencies: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
        """Return the one-sided density [unit^2/Hz] at ``frequencies`` [Hz], 0 at half the rate [Hz] and above."""
        at = np.maximum(frequencies, 1e-9)
        away = np.log(at) - log(self.frequency)
        return np.asarray(
            self.rms**2
            / (at * self.width * sqrt(2 * pi))
            * np.exp(-0.5 * (away / self.width) ** 2)
            * (frequencies < 0.5 * rate)
        )

    def density_between(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the mean density [unit^2/Hz] between frequencies ``low`` and ``high`` [Hz]."""
        from scipy.special import ndtr

        edges = [np.log(edge / self.frequency) / self.width for edge in (low, high)]
        return np.asarray(self.rms**2 * (ndtr(edges[1]) - ndtr(edges[0])) / (high - low))

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the noise on its torque channel."""
        name, rate = recording.torque_name(), recording.sample_rate
        values = recording.channels[name].values
        white = np.fft.rfft(recording.random("noise hump").standard_normal(values.size))
        at = np.linspace(0.0, 0.5 * rate, white.size)
        shape = np.sqrt(self.density(at, rate) * rate / 2)
        return recording.with_values(name, values + np.fft.irfft(white * shape, values.size))
