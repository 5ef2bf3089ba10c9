"""Low-pass of the sensor's amplifier."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class AmplifierLowPass:
    """An analog Butterworth low-pass, as between the bridge of a torque sensor and its converter.

    H(s) = 1 / (s^2/wc^2 + sqrt(2) s/wc + 1) for order 2. The filter is solved exactly for a signal that runs straight
    from sample to sample (first-order hold), and starts in the steady state of the first sample.

    Parameters
    ----------
    cutoff : float
        Frequency of -3 dB [Hz], > 0.
    order : int
        1 to 4.

    Notes
    -----
    Source: handbook 6.1; first-order hold: Franklin, Powell & Workman, Digital Control of Dynamic Systems, ch. 6.
    Straight lines between samples lose sinc^2(f / rate) of a sine: under 1 % below 0.055 of the sample rate, 5 % at
    0.12. Above that, simulate at a higher rate; what lies above half the rate is aliased before it comes here.
    """

    cutoff: float
    order: int = 2

    def __post_init__(self) -> None:
        if not self.cutoff > 0 or not 1 <= self.order <= 4:
            raise InputError(
                f"an amplifier with a cutoff of {self.cutoff} Hz and order {self.order} cannot be; "
                "the cutoff must be above 0 Hz, the order 1 to 4"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel low-passed."""
        from scipy.signal import lfilter

        name = recording.torque_name()
        values = recording.channels[name].values
        if values.size == 0:
            raise RecordingError(f"{recording.name}: {name} has no samples; an amplifier needs at least one")
        b, a = _discrete(self.cutoff, self.order, recording.sample_rate)
        first = values[0]
        # relative to the first sample, so that a constant is kept to the last bit
        return recording.with_values(name, lfilter(b, a, values - first) + first)


@cache
def _discrete(cutoff: float, order: int, rate: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    from scipy.signal import butter, cont2discrete

    b, a, _ = cont2discrete(butter(order, 2 * np.pi * cutoff, analog=True), 1 / rate, method="foh")
    return np.atleast_1d(np.squeeze(b)), np.atleast_1d(a)
