"""Tones of fixed frequency: mains hum, pulse-width modulation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Tone:
    """V += sum_h a_h cos(2 pi h f t + phi_h), t counted from the first sample; independent of the speed.

    Parameters
    ----------
    frequency : float
        f [Hz], > 0. Above half the sample rate it is aliased to ``|f - n rate|``.
    amplitudes : tuple of float
        a_1, a_2, ..., zero to peak, in the unit of the torque channel, >= 0.
    phases : tuple of float
        phi_1, phi_2, ... [rad]; those not stated are drawn by the recording's random seed.
    source : str
        Name of the cause, which determines the random phases.

    Notes
    -----
    Source: handbook 2.7, 2.8, 6.12. Not valid for a mains whose frequency wanders (0.01 to 0.1 Hz) over minutes.
    """

    frequency: float
    amplitudes: tuple[float, ...]
    phases: tuple[float, ...] = ()
    source: str = "tone"

    def __post_init__(self) -> None:
        if not self.frequency > 0 or not all(amplitude >= 0 for amplitude in self.amplitudes):
            raise InputError(
                f"a tone of {self.frequency} Hz and amplitudes {self.amplitudes} cannot be; "
                "the frequency must be above 0 Hz, the amplitudes 0 V or more"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the tone on its torque channel."""
        if not any(self.amplitudes):
            return recording
        name = recording.torque_name()
        turn = 2 * np.pi * self.frequency * recording.time()
        values = recording.channels[name].values.copy()
        for harmonic, amplitude in enumerate(self.amplitudes, start=1):
            if harmonic <= len(self.phases):
                phase = self.phases[harmonic - 1]
            else:
                phase = recording.random(f"phase {self.source}.{harmonic}").uniform(0, 2 * np.pi)
            values += amplitude * np.cos(harmonic * turn + phase)
        return recording.with_values(name, values)


def folded(frequency: float, sample_rate: float) -> float:
    """Return where ``frequency`` appears in samples taken at ``sample_rate``: |f - n rate|, at most half the rate [Hz].

    Source: handbook 6.12 (Oppenheim & Schafer, Discrete-Time Signal Processing, sampling theorem).
    """
    return abs((frequency + 0.5 * sample_rate) % sample_rate - 0.5 * sample_rate)
