"""FIR low-pass (Kaiser window), zero-phase or causal with the same delay at all frequencies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]

_STOP_DB = 80.0


@dataclass(frozen=True, kw_only=True)
class FirLowPass:
    """A Kaiser-windowed low-pass centred on each sample: gain 1/2 at the cutoff, -80 dB above the transition.

    Parameters
    ----------
    cutoff : float
        Gain 1/2 [Hz], > 0 and below half the rate.
    transition : float
        Width from pass band to stop band [Hz], > 0, centred on the cutoff; the window is 5 / transition long.

    Notes
    -----
    Source: Kaiser 1974; Oppenheim & Schafer, Discrete-Time Signal Processing, section 7.6. The ends are continued
    point-symmetrically.
    """

    cutoff: float
    transition: float

    def __post_init__(self) -> None:
        _check(self.cutoff, self.transition)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque low-passed; RecordingError where it is too short or too slow."""
        name, taps = recording.torque_name(), _taps(recording, self.cutoff, self.transition)
        values, half = recording.channels[name].values, taps.size // 2
        head, tail = 2 * values[0] - values[half:0:-1], 2 * values[-1] - values[-2 : -half - 2 : -1]
        return recording.with_values(name, _convolved(np.concatenate([head, values, tail]), taps))

    def reach(self, head: Recording) -> float:
        """Return half the window [s]."""
        return _taps(head, self.cutoff, self.transition).size / 2 / head.sample_rate


@dataclass(frozen=True, kw_only=True)
class CausalFirLowPass:
    """The causal form: the window ends at each sample, and all frequencies are delayed by half of it (:meth:`delay`).

    Parameters
    ----------
    cutoff, transition : float
        As in :class:`FirLowPass`.
    """

    cutoff: float
    transition: float

    def __post_init__(self) -> None:
        _check(self.cutoff, self.transition)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque low-passed; before it, the first value is taken to have stood."""
        name, taps = recording.torque_name(), _taps(recording, self.cutoff, self.transition)
        values = recording.channels[name].values
        before = np.full(taps.size - 1, values[0])
        return recording.with_values(name, _convolved(np.concatenate([before, values]), taps))

    def delay(self, recording: Recording) -> float:
        """Return by how much everything is late [s]."""
        return (_taps(recording, self.cutoff, self.transition).size - 1) / 2 / recording.sample_rate

    def reach(self, head: Recording) -> float:
        """Return the window [s]."""
        return 2 * self.delay(head)


def _taps(recording: Recording, cutoff: float, transition: float) -> Floats:
    from scipy.signal import firwin, kaiserord

    rate = recording.sample_rate
    if cutoff + transition / 2 >= rate / 2:
        raise RecordingError(
            f"{recording.name}: a low-pass at {cutoff:g} Hz with a transition of {transition:g} Hz needs a sample rate "
            f"above {2 * cutoff + transition:g} Hz, and this one has {rate:g} Hz; lower the cutoff"
        )
    count, beta = kaiserord(_STOP_DB, transition / (rate / 2))
    count |= 1
    if recording.samples <= count // 2:
        raise RecordingError(
            f"{recording.name}: {recording.samples} samples are too few for a window of {count}; "
            "take a longer recording or a wider transition"
        )
    return np.asarray(firwin(count, cutoff, window=("kaiser", beta), fs=rate))


def _convolved(values: Floats, taps: Floats) -> Floats:
    from scipy.signal import oaconvolve

    offset = values[0]  # subtracted to reduce rounding errors of the transform
    return np.asarray(oaconvolve(values - offset, taps, mode="valid") + offset)


def _check(cutoff: float, transition: float) -> None:
    if not (cutoff > 0 and 0 < transition <= 2 * cutoff):
        raise InputError(
            f"a low-pass with a cutoff of {cutoff} Hz and a transition of {transition} Hz is not possible; "
            "both must be above 0 Hz, the transition at most twice the cutoff"
        )
