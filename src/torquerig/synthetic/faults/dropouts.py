"""Moments in which the signal is lost before the amplifier, whose low-pass rounds the edges."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import Floats
from torquerig.synthetic.faults.moments import drawn_moments, in_samples, within


@dataclass(frozen=True, kw_only=True)
class Dropouts(DrawnFault):
    """The reading falls to one level and comes back.

    The low-pass is a second-order Butterworth. What is faster than it, such as the noise of the converter, goes on.
    The mark ends where the low-pass has come back to 1 % of the step, 1.04 / cutoff after the moment.
    """

    type: Literal["dropouts"] = "dropouts"
    length: Annotated[float, Parameter("s", "length of each moment", low=0)] = 6e-3
    rate: Annotated[float, Parameter("1/s", "number of moments", low=0)] = 100 / 60
    level: Annotated[float, Parameter("N*m", "reading without a signal")] = 0.0
    cutoff: Annotated[float, Parameter("Hz", "cut-off of the low-pass behind the fault; 0 Hz: none", low=0)] = 300.0

    zero: ClassVar[dict[str, Any]] = {"rate": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = r"comes back \d+ times"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with dropouts, and the moments from the first edge until the last has passed."""
        length = in_samples(self.length, recording, fault=self.type)
        starts = drawn_moments(recording, self.rate, rng, length=max(length, 1), fault=self.type)
        lost = within(recording.samples, starts, length)
        name = recording.torque_name()
        channel = recording.channels[name]
        step = np.where(lost, self.level / channel.si_per_unit - channel.values, 0.0)
        if not lost.any() or self.cutoff == 0:
            return Disturbed(recording=recording.with_values(name, _put(channel.values, step, lost)), affected=lost)
        passed = _low_passed(step, recording, self.cutoff)
        tail = round(_SETTLED / self.cutoff * recording.sample_rate)
        affected = within(recording.samples, starts, length + tail)
        return Disturbed(
            recording=recording.with_values(name, _put(channel.values, passed, affected)), affected=affected
        )


# exp(-2 pi cutoff t / sqrt 2) is 1 % then
_SETTLED = 1.04


def _put(values: Floats, change: Floats, affected: NDArray[np.bool_]) -> Floats:
    return np.where(affected, values + change, values)


def _low_passed(step: Floats, recording: Recording, cutoff: float) -> Floats:
    if cutoff >= recording.sample_rate / 2:
        raise InputError(
            f"dropouts: a cut-off of {cutoff:g} Hz is not below half the sample rate of {recording.sample_rate:g} Hz; "
            "lower it, or write cutoff: 0 Hz for none"
        )
    from scipy.signal import butter, sosfilt

    return np.asarray(sosfilt(butter(2, cutoff, fs=recording.sample_rate, output="sos"), step))
