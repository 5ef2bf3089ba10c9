"""Analog-digital converter: range and rounding to codes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Converter:
    """Clips to the range and rounds to the nearest code: V = step * round(V / step), step = 2 range / 2^bits.

    Mid-tread: zero is a code; the codes run from -range to range - step (two's complement).

    Parameters
    ----------
    range_V : float
        Half of the input span [V], > 0: 10 for a converter of +-10 V.
    bits : int
        1 to 32.

    Notes
    -----
    Source: handbook 6.8, 6.9 (Widrow & Kollar, Quantization Noise): the error is at most half a step within the
    range, step / sqrt(12) rms where the signal crosses many codes. Nonlinearity and missing codes are not modelled.
    """

    range_V: float  # noqa: N815 (the unit is part of the name)
    bits: int

    def __post_init__(self) -> None:
        if not self.range_V > 0 or not 1 <= self.bits <= 32:
            raise InputError(
                f"a converter of +-{self.range_V} V and {self.bits} bit cannot be; "
                "the range must be above 0 V, the bits 1 to 32"
            )

    @property
    def step(self) -> float:
        """The size of one code [V]."""
        return float(2 * self.range_V / 2**self.bits)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel converted; the values stay in volts."""
        name = recording.torque_name()
        half = 2 ** (self.bits - 1)
        codes = np.clip(np.round(recording.channels[name].values / self.step), -half, half - 1)
        return recording.with_values(name, codes * self.step)
