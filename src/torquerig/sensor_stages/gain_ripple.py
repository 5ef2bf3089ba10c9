"""Gain of a reading that varies with an angle or with time; an empirical description without a cause."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class GainRipple:
    """``T (1 + sum_h g_h cos(h (n theta + 2 pi f t) + phi_h))``: lines in proportion to the torque.

    Parameters
    ----------
    depths : tuple of float
        g_1, g_2, ... [1], >= 0.
    order : float
        n, per turn of ``angle`` [1].
    frequency : float
        f [Hz]; t is counted from the first sample. Either n or f is 0.
    angle : str
        Name of the channel with the true angle.
    source : str
        Name of the cause, which determines the random phases.

    Notes
    -----
    An empirical description. Not valid for a line that grows otherwise than in proportion to the torque.
    """

    depths: tuple[float, ...]
    order: float = 0.0
    frequency: float = 0.0
    angle: str = "true_motor_angle_rad"
    source: str = "gain"

    def __post_init__(self) -> None:
        if min(self.depths, default=0.0) < 0 or min(self.order, self.frequency) < 0 or self.order * self.frequency:
            raise InputError("a gain varies with an order or with a frequency, by 0 or more; the phase is drawn")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the varying gain on its torque channel."""
        if not any(self.depths):
            return recording
        name = recording.torque_name()
        turn = 2 * np.pi * self.frequency * recording.time()
        if self.order:
            turn = turn + self.order * recording.channel(self.angle).in_si()
        gain = np.ones(turn.size)
        phases = recording.random(f"phases {self.source}").uniform(0, 2 * np.pi, len(self.depths))
        for harmonic, (depth, phase) in enumerate(zip(self.depths, phases, strict=True), start=1):
            gain += depth * np.cos(harmonic * turn + phase)
        return recording.with_values(name, recording.channels[name].values * gain)
