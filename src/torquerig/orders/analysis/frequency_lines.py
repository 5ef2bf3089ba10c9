"""Lines of the torque over frequency alone, where the speed of the shaft is not known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.orders.analysis.aliases import alias_of
from torquerig.orders.analysis.labels import mains_multiple
from torquerig.orders.analysis.order_spectrum import frequency_spectrum, line_amplitude
from torquerig.orders.analysis.peaks import peaks_of

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

_LOWEST_BINS = 8  # periods of a line in the recording, at least, to be distinguished from drift
_BLURRED = 12  # bins
_HUMS = 20  # multiples of the mains that are expected


@dataclass(frozen=True)
class FrequencyLine:
    """A line at ``frequency`` [Hz]: amplitude [N m], level above the noise floor, multiple of the mains."""

    frequency: float
    amplitude: float
    above_dB: float  # noqa: N815  (decibel is written dB)
    mains_multiple: int | None


def possible_aliases(
    recording: Recording, lines: Sequence[KinematicLine], *, turns_per_second: float, half_width: float = 0.0
) -> list[tuple[FrequencyLine, KinematicLine]]:
    """Return each line of the torque that may be the alias of a line of the rig above half the sample rate.

    Parameters
    ----------
    lines : sequence of KinematicLine
        The lines that the rig can have.
    turns_per_second : float
        Of the output shaft [1/s].
    half_width : float
        Relative half width of the speed's interval [1]. Where it blurs the frequency of a line over more than a dozen
        bins, nearly every line could be its alias, and it is left out.
    """
    rate, bin_width = recording.sample_rate, 1 / recording.duration
    sharp = [line for line in lines if half_width * line.output_order * turns_per_second < _BLURRED * bin_width]
    if not any(line.output_order * turns_per_second > rate / 2 for line in sharp):
        return []
    own = [line.output_order * turns_per_second for line in sharp if line.output_order * turns_per_second < rate / 2]
    found = []
    for one in frequency_lines(recording):
        width = 1.5 * bin_width + half_width * rate / 2
        if one.mains_multiple or any(abs(one.frequency - place) < width for place in own):
            continue
        alias = alias_of(one.frequency, sharp, turns_per_second=turns_per_second, rate=rate, width=width)
        if alias is not None:
            found.append((one, alias))
    return found


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
