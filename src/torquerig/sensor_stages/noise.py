"""Noise of the sensor, white or with a first-order spectrum."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class WhiteNoise:
    """Gaussian noise: V += rms * n, white, or tilted: n_t = colour n_(t-1) + sqrt(1 - colour^2) w_t.

    Parameters
    ----------
    rms : float
        [V], that is in the unit of the torque channel, >= 0.
    colour : float
        Correlation of neighbouring samples [1], -1..1: 0 is white, more leans to low frequencies, less to high ones.

    Notes
    -----
    Source: handbook 6.7. The same recording seed gives the same noise, independent of other stages. Real noise
    has more power at low frequencies and lines of the carrier, which are not modelled. The tilt is an autoregression of
    first order (Box & Jenkins, Time Series Analysis, section 3.2.3).
    """

    rms: float
    colour: float = 0.0

    def __post_init__(self) -> None:
        if not self.rms >= 0:
            raise InputError(f"a noise of {self.rms} V rms cannot be; write 0 V or more")
        if not -1 < self.colour < 1:
            raise InputError(
                f"a noise whose neighbours correlate by {self.colour} cannot be; write more than -1, less than 1"
            )

    def density(self, frequencies: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
        """Return the one-sided density [V^2/Hz] at ``frequencies`` [Hz] of samples taken at ``rate`` [Hz]."""
        turned = np.abs(1 - self.colour * np.exp(-2j * np.pi * frequencies / rate)) ** 2
        return np.asarray(2 * self.rms**2 / rate * (1 - self.colour**2) / turned)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with noise on its torque channel."""
        name = recording.torque_name()
        values = recording.channels[name].values
        if self.rms == 0:
            return recording
        noise = recording.random("sensor noise").standard_normal(values.size)
        if self.colour:
            from scipy.signal import lfilter

            noise = lfilter([sqrt(1 - self.colour**2)], [1.0, -self.colour], noise)
        return recording.with_values(name, values + self.rms * noise)
