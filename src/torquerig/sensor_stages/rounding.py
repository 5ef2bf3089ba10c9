"""Rounding of a voltage to coarse codes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Rounding:
    """V = step round(V / step), ties to even; a step of 0 changes nothing.

    Parameters
    ----------
    step : float
        Distance of two codes, in the unit of the torque channel, >= 0.

    Notes
    -----
    Source: handbook 6.8 (Widrow & Kollar, Quantization Noise): step / sqrt(12) rms where the signal crosses many
    codes; where it stays within one or two, the error is tonal and the mean may be off by half a step.
    """

    step: float

    def __post_init__(self) -> None:
        if not self.step >= 0:
            raise InputError(f"codes {self.step} V apart cannot be; the step must be 0 V or more")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel on the codes."""
        if self.step == 0:
            return recording
        name = recording.torque_name()
        return recording.with_values(name, self.step * np.round(recording.channels[name].values / self.step))
