"""Flicker noise of an amplifier: power that rises towards low frequencies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class FlickerNoise:
    """Gaussian noise of one-sided density ``D(f) = (2 rms^2 / rate) (corner / f)^exponent``, added to the torque.

    At the corner it equals white noise of ``rms``. It is made for twice the length, so that the end does not continue
    the start; below one period in that time there is nothing.

    Parameters
    ----------
    rms : float
        Of the white noise [unit of the torque channel], >= 0.
    corner : float
        [Hz], >= 0.
    exponent : float
        1 is pink, 2 is a random walk; > 0.

    Notes
    -----
    Source: Horowitz & Hill, The Art of Electronics, 3rd ed., section 8.1.3 (1/f corner).
    """

    rms: float
    corner: float
    exponent: float = 1.0

    def __post_init__(self) -> None:
        if not (self.rms >= 0 and self.corner >= 0 and self.exponent > 0):
            raise InputError("flicker noise needs an rms and a corner of 0 or more, and an exponent of more than 0")

    def density(self, frequencies: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
        """Return the one-sided density [unit^2/Hz] at ``frequencies`` [Hz], 0 at 0 Hz, at a sample rate [Hz]."""
        at = np.asarray(frequencies, dtype=float)
        safe = np.where(at > 0, at, 1.0)
        return np.where(at > 0, 2 * self.rms**2 / rate * (self.corner / safe) ** self.exponent, 0.0)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the noise on its torque channel."""
        if self.rms == 0 or self.corner == 0:
            return recording
        name, rate = recording.torque_name(), recording.sample_rate
        values = recording.channels[name].values
        count = 2 * values.size
        white = np.fft.rfft(recording.random("flicker noise").standard_normal(count))
        at = np.linspace(0.0, 0.5 * rate, white.size)
        shape = np.sqrt(self.density(at, rate) * rate / 2)
        return recording.with_values(name, values + np.fft.irfft(white * shape, count)[: values.size])
