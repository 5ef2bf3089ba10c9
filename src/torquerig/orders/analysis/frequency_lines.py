"""Lines of the torque over frequency alone, where the speed of the shaft is not known."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.orders.analysis.labels import mains_multiple
from torquerig.orders.analysis.order_spectrum import frequency_spectrum, line_amplitude
from torquerig.orders.analysis.peaks import peaks_of

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

_LOWEST_BINS = 8  # periods of a line in the recording, at least, to be distinguished from drift
_HUMS = 20  # multiples of the mains that are expected


@dataclass(frozen=True)
class FrequencyLine:
    """A line at ``frequency`` [Hz]: amplitude [N m], level above the noise floor, multiple of the mains."""

    frequency: float
    amplitude: float
    above_dB: float  # noqa: N815  (decibel is written dB)
    mains_multiple: int | None


def frequency_lines(recording: Recording, *, mains: float = 50.0) -> tuple[FrequencyLine, ...]:
    """Return the lines of the torque up to half the sample rate, by rising frequency; ``mains`` in [Hz]."""
    torque = recording.torque()
    spectrum = frequency_spectrum(torque, recording.sample_rate)
    hum = [multiple * mains for multiple in range(1, _HUMS + 1)]
    peaks = peaks_of(spectrum, lowest=_LOWEST_BINS * spectrum.width, expected=hum)
    width = 1.5 / recording.duration
    return tuple(
        FrequencyLine(
            frequency=one.place,
            amplitude=line_amplitude(torque, recording.time(), one.place),
            above_dB=one.above_dB,
            mains_multiple=mains_multiple(one.place, mains=mains, width=width),
        )
        for one in sorted(peaks, key=lambda peak: peak.place)
    )
