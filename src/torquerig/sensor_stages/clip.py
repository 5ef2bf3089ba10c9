"""Clipping by a saturated amplifier or input."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Clip:
    """V = min(max(V, -limit), limit): flat tops at the supply rail or at full scale.

    Parameters
    ----------
    limit : float
        In the unit of the torque channel, > 0.

    Notes
    -----
    Source: handbook 6.9. Real rails differ in sign and take microseconds to recover; neither is modelled.
    """

    limit: float

    def __post_init__(self) -> None:
        if not self.limit > 0:
            raise InputError(f"a signal cannot be clipped at {self.limit} V; the limit must be above 0 V")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel clipped."""
        name = recording.torque_name()
        return recording.with_values(name, np.clip(recording.channels[name].values, -self.limit, self.limit))
