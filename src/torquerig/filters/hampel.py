"""What is left when spikes are replaced by the median around them."""

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
    """Replaces a sample by the median of its neighbours where it lies too far from it; all others stay untouched.

    Parameters
    ----------
    half_window : int
        Neighbours to either side, >= 1; spikes of up to so many samples are seen.
    deviations : float
        How far is too far, in robust standard deviations of the neighbours, > 0.

    Notes
    -----
    Source: Hampel 1974, J. Am. Stat. Assoc. 69, 383-393; Pearson et al. 2016, EURASIP J. Adv. Signal Process. 2016:87.
    Where it stops being true: hits of the load that are as short as the window are spikes to it; where more than half
    of the neighbours are equal (a coarse converter) a deviation of nothing would make each change a spike, so that at
    least the smallest step of the recording is allowed.
    """

    half_window: int = 10
    deviations: float = 5.0

    def __post_init__(self) -> None:
        if self.half_window < 1 or not self.deviations > 0:
            raise InputError(
                f"a spike remover over {self.half_window} neighbours and {self.deviations} deviations cannot be; "
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
        spread = np.maximum(_DEVIATIONS_PER_MAD * distance, least)
        away = np.abs(values - median)
        return recording.with_values(name, np.where(away > self.deviations * spread, median, values))

    def reach(self, head: Recording) -> float:
        """Return how far it looks to either side [s]."""
        return 2 * self.half_window / head.sample_rate
