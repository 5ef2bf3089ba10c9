"""Hampel filter: spikes are replaced by the median of their neighbours."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

_DEVIATIONS_PER_MAD = 1.4826  # of a normal distribution


@dataclass(frozen=True, kw_only=True)
class Hampel:
    """Replaces a sample by the median of its neighbours where it deviates too far; other samples are not changed.

    Parameters
    ----------
    half_window : int
        Neighbours on either side, >= 1; also the longest spike that is detected [samples].
    deviations : float
        Threshold in robust standard deviations of the neighbours [1], > 0.

    Notes
    -----
    Source: Hampel 1974, J. Am. Stat. Assoc. 69, 383-393; Pearson et al. 2016, EURASIP J. Adv. Signal Process. 2016:87.
    Limits: load hits as short as the window are treated as spikes. Where more than half of the neighbours are equal (a
    coarse converter), the robust deviation is 0; the smallest step of the recording is then used instead.
    """

    half_window: int = 10
    deviations: float = 5.0

    def __post_init__(self) -> None:
        if self.half_window < 1 or not self.deviations > 0:
            raise InputError(
                f"a Hampel filter over {self.half_window} neighbours and {self.deviations} deviations is not possible; "
                "write at least 1, and more than 0"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the spikes of its torque replaced."""
        from torquerig.filters.kernel import medians

        name = recording.torque_name()
        values = recording.channels[name].values
        if values.size < 3:
            return recording
        median, distance = medians(np.ascontiguousarray(values), self.half_window)
        steps = np.abs(np.diff(values))
        least = float(steps[steps > 0].min()) if steps.any() else 0.0
        scale = np.maximum(_DEVIATIONS_PER_MAD * distance, least)
        deviation = np.abs(values - median)
        return recording.with_values(name, np.where(deviation > self.deviations * scale, median, values))

    def reach(self, head: Recording) -> float:
        """Return twice the half window [s]."""
        return 2 * self.half_window / head.sample_rate
