"""A line above half the sample rate that no low-pass kept out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.recordings.channel_angle import angle_of
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import angle_name, with_added_torque


@dataclass(frozen=True, kw_only=True)
class Alias(DrawnFault):
    """A line of the shaft, at ``order`` periods per turn of the measured angle; it appears below half the rate.

    The angle is smoothed, so that the steps of the encoder modulate no line: of the speed, what is slower than 20 Hz is
    kept.
    """

    type: Literal["alias"] = "alias"
    amplitude: Annotated[float, Parameter("N*m", "of the line, zero to peak", low=0)] = 0.02
    order: Annotated[float, Parameter("1", "periods per turn of the measured angle", above=0)] = 336.0

    zero: ClassVar[dict[str, Any]] = {"amplitude": 0.0}
    acts_on: ClassVar[Acts] = "whole"
    named_by: ClassVar[tuple[str, ...]] = ("ordermap",)
    named_as: ClassVar[str] = "alias of"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the line."""
        if self.amplitude == 0:
            return Disturbed(recording=recording)
        angle = _smooth(angle_of(recording.channels[angle_name(recording, fault=self.type)], recording.sample_rate),
                        recording.sample_rate)  # fmt: skip
        frequency = self.order * abs(float(angle[-1] - angle[0])) / (2 * np.pi * recording.duration)
        if frequency <= recording.sample_rate / 2:
            raise InputError(
                f"alias: order {self.order:g} is at {frequency:.4g} Hz, which is not above half the sample rate of "
                f"{recording.sample_rate:g} Hz; write an order above "
                f"{self.order * recording.sample_rate / 2 / max(frequency, 1e-12):.4g}"
            )
        added = self.amplitude * np.cos(self.order * angle + rng.uniform(0, 2 * np.pi))
        return Disturbed(recording=with_added_torque(recording, added))


_SLOW = 20.0  # [Hz] of the speed variation that is kept
_SHORTEST = 32  # samples that the filter needs on either side


def _smooth(angle: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
    """Return the angle with its deviations from a steady speed low-passed; as it is where it has too few samples."""
    if rate <= 4 * _SLOW or angle.size <= _SHORTEST:
        return angle
    from scipy.signal import butter, sosfiltfilt

    steady = np.linspace(angle[0], angle[-1], angle.size)
    return np.asarray(steady + sosfiltfilt(butter(2, _SLOW, fs=rate, output="sos"), angle - steady))
