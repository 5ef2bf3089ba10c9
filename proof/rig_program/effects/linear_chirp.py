"""In no library: a whistle that sweeps from one frequency to another over each run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class LinearChirp(Effect):
    """V += a cos(2 pi (f0 t + (f1 - f0) t^2 / 2T)) from f0 to f1 [Hz]."""

    kind: ClassVar[str] = "linear_chirp"
    in_library: ClassVar[bool] = False
    start: float
    end: float
    amplitude: float

    def parameters(self) -> dict[str, float | None]:
        """Both frequencies and the amplitude."""
        return {"start_Hz": self.start, "end_Hz": self.end, "amplitude_V": self.amplitude}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Add the whistle."""
        time = np.arange(volts.size) / nominal.SAMPLE_RATE
        turns = self.start * time + 0.5 * (self.end - self.start) * time**2 / run.duration
        return np.asarray(volts + self.amplitude * np.cos(2.0 * np.pi * turns + rng.uniform(0.0, 2.0 * np.pi)))


def draw_linear_chirp(rng: np.random.Generator, setting: Setting, *, size: float) -> LinearChirp:
    """Draw a sweep by half as much again or more, up or down, of 8 mV to 0.4 V."""
    low = float(100.0 * 20.0 ** rng.random())
    ends = [low, low * float(rng.uniform(1.5, 4.0))]
    rng.shuffle(ends)
    return LinearChirp(ends[0], ends[1], between(0.008, 0.4, size=size))
