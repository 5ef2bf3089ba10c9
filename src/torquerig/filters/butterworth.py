"""Butterworth low-pass, zero-phase or causal."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.filters.biquads import cascaded, slow_delay

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording

DESIGNS = 64  # low-passes whose sections are kept: a design takes 0.2 ms, filtering 2 s at 25 kHz 1.2 ms


@dataclass(frozen=True, kw_only=True)
class ButterworthLowPass:
    """A Butterworth low-pass, run forwards and backwards: gain 1 / (1 + (f/fc)^2n), no phase.

    Parameters
    ----------
    cutoff : float
        [Hz], > 0 and below half the sample rate; -3 dB of each pass, so -6 dB (a half) of both.
    order : int
        n of each pass, 1 to 10.

    Notes
    -----
    Source: Oppenheim & Schafer, Discrete-Time Signal Processing (forward-backward filtering). Near half the sample
    rate the bilinear transform distorts the frequency axis; the first and last 1/cutoff seconds depend on the mirrored
    ends.
    """

    cutoff: float
    order: int = 4

    def __post_init__(self) -> None:
        if not self.cutoff > 0 or not 1 <= self.order <= 10:
            raise InputError(
                f"a low-pass with a cutoff of {self.cutoff} Hz and order {self.order} is not possible; "
                "the cutoff must be above 0 Hz, the order 1 to 10"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque low-passed; RecordingError where it is too short or too slow."""
        from scipy.signal import sosfiltfilt

        name, rate = recording.torque_name(), recording.sample_rate
        values = recording.channels[name].values
        if self.cutoff >= rate / 2:
            raise RecordingError(
                f"{recording.name}: a low-pass at {self.cutoff:g} Hz needs a sample rate above {2 * self.cutoff:g} Hz, "
                f"and this one has {rate:g} Hz; lower the cutoff"
            )
        ring = int(rate / self.cutoff)
        if values.size < 3 * ring:
            raise RecordingError(
                f"{recording.name}: {values.size} samples are too few for a low-pass at {self.cutoff:g} Hz; "
                f"it needs {3 * ring}, three periods of its cutoff"
            )
        sections = low_pass_sections(self.order, self.cutoff, rate)
        offset = values[0]
        return recording.with_values(name, sosfiltfilt(sections, values - offset, padlen=ring) + offset)


@dataclass(frozen=True, kw_only=True)
class CausalButterworthLowPass:
    """A causal Butterworth low-pass: gain 1 / sqrt(1 + (f/fc)^2n), slow load delayed by :meth:`delay`.

    Parameters
    ----------
    cutoff : float
        -3 dB [Hz], > 0 and below half the sample rate.
    order : int
        n, 1 to 10.
    """

    cutoff: float
    order: int = 4

    def __post_init__(self) -> None:
        ButterworthLowPass(cutoff=self.cutoff, order=self.order)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` low-passed sample by sample; the signal before it is taken as its first value."""
        from scipy.signal import sosfilt_zi

        name = recording.torque_name()
        values, sections = recording.channels[name].values, self._sections(recording)
        if not values.size:
            return recording
        return recording.with_values(name, cascaded(values, sections, states=sosfilt_zi(sections) * values[0])[0])

    def delay(self, recording: Recording) -> float:
        """Return the delay of slow load [s]: the group delay at 0 Hz."""
        return slow_delay(self._sections(recording)) / recording.sample_rate

    def reach(self, head: Recording) -> float:
        """Return the length of the impulse response [s]."""
        return max(10 / self.cutoff, 1 / head.sample_rate)

    def _sections(self, recording: Recording) -> NDArray[np.float64]:
        if self.cutoff >= recording.sample_rate / 2:
            raise RecordingError(
                f"{recording.name}: a low-pass at {self.cutoff:g} Hz needs a sample rate above {2 * self.cutoff:g} Hz, "
                f"and this one has {recording.sample_rate:g} Hz; lower the cutoff"
            )
        return low_pass_sections(self.order, self.cutoff, recording.sample_rate)


def low_pass_sections(order: int, cutoff: float, rate: float) -> NDArray[np.float64]:
    """Return the second-order sections of a Butterworth low-pass, shape (sections, 6).

    Parameters
    ----------
    order : int
    cutoff, rate : float
        Cutoff frequency and samples per second [Hz].
    """
    return _designed(order, cutoff, rate).copy()


@lru_cache(maxsize=DESIGNS)
def _designed(order: int, cutoff: float, rate: float) -> NDArray[np.float64]:
    from scipy.signal import butter

    return np.asarray(butter(order, cutoff, fs=rate, output="sos"))
