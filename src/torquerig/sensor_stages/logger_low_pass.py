"""Low-pass of a data logger, of any order."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording

Characteristic = Literal["butterworth", "bessel"]
HIGHEST = 10  # of the order; more has no data logger


@dataclass(frozen=True, kw_only=True)
class LoggerLowPass:
    """An analog Butterworth or Bessel low-pass in second-order sections, -3 dB at ``cutoff``.

    Each section is solved exactly for a signal that runs straight from sample to sample, and starts in the steady state
    of the first sample. Every section also loses ``sinc^2(f / rate)``: 0.5 % at 0.04 of the sample rate.

    Parameters
    ----------
    cutoff : float
        [Hz], > 0.
    order : int
        0 to 10; 0 passes everything.
    characteristic : {"butterworth", "bessel"}

    Notes
    -----
    Source: Butterworth 1930; Thomson 1949 (Bessel), normalised to -3 dB. First-order hold: Franklin, Powell & Workman,
    Digital Control of Dynamic Systems, ch. 6.
    """

    cutoff: float
    order: int
    characteristic: Characteristic = "butterworth"

    def __post_init__(self) -> None:
        if not (self.cutoff > 0 and 0 <= self.order <= HIGHEST):
            raise InputError(f"a low-pass of order {self.order} at {self.cutoff} Hz cannot be; the cutoff is above "
                             f"0 Hz, the order 0 to {HIGHEST}")  # fmt: skip

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel low-passed."""
        from scipy.signal import lfilter

        name = recording.torque_name()
        values = recording.channels[name].values
        if self.order == 0 or values.size == 0:
            return recording
        first = values[0]
        passed = values - first  # relative to the first sample, so that a constant is kept to the last bit
        for b, a in _sections(self.cutoff, self.order, self.characteristic, recording.sample_rate):
            passed = lfilter(b, a, passed)
        return recording.with_values(name, passed + first)


@cache
def _sections(
    cutoff: float, order: int, characteristic: Characteristic, rate: float
) -> tuple[tuple[NDArray[np.float64], NDArray[np.float64]], ...]:
    from scipy.signal import bessel, butter, cont2discrete

    turning = 2 * np.pi * cutoff
    made: Any = butter(order, turning, analog=True, output="zpk") if characteristic == "butterworth" else bessel(
        order, turning, analog=True, output="zpk", norm="mag")  # fmt: skip
    poles = made[1]
    above = [np.real(np.poly([pole, pole.conj()])) for pole in poles if pole.imag > 1e-9 * abs(pole)]
    real = [np.real(np.poly([pole])) for pole in poles if abs(pole.imag) <= 1e-9 * abs(pole)]
    found = []
    for section in (*above, *real):
        b, a, _ = cont2discrete(([section[-1]], section), 1 / rate, method="foh")
        found.append((np.atleast_1d(np.squeeze(b)), np.atleast_1d(a)))
    return tuple(found)
