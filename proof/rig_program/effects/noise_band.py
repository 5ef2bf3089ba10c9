"""In no library: a band of noise that swells and fades."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class NoiseBand(Effect):
    """Noise of this rms [V] around a centre [Hz], its strength modulated at a slow rate [Hz]."""

    kind: ClassVar[str] = "noise_band"
    in_library: ClassVar[bool] = False
    centre: float
    width: float
    rms: float
    rate: float

    def parameters(self) -> dict[str, float | None]:
        """Centre, width, rms and rate."""
        return {"centre_Hz": self.centre, "width_Hz": self.width, "rms_V": self.rms, "rate_Hz": self.rate}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Add the noise."""
        spectrum = np.fft.rfft(rng.standard_normal(volts.size))
        frequency = np.fft.rfftfreq(volts.size, 1.0 / nominal.SAMPLE_RATE)
        band = np.fft.irfft(spectrum * np.exp(-0.5 * ((frequency - self.centre) / self.width) ** 2), volts.size)
        time = np.arange(volts.size) / nominal.SAMPLE_RATE
        band *= 1.0 + 0.9 * np.cos(2.0 * np.pi * self.rate * time + rng.uniform(0.0, 2.0 * np.pi))
        return np.asarray(volts + band * (self.rms / band.std()))


def draw_noise_band(rng: np.random.Generator, setting: Setting, *, size: float) -> NoiseBand:
    """Draw a band around 200 to 3000 Hz of 4 mV to 0.3 V rms."""
    centre = float(200.0 * 15.0 ** rng.random())
    return NoiseBand(
        centre, centre * float(rng.uniform(0.02, 0.1)), between(0.004, 0.3, size=size), float(rng.uniform(0.2, 3.0))
    )
