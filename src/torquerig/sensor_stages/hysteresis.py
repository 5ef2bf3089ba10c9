"""Hysteresis of a sensor: the reading lags behind a torque that reverses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Hysteresis:
    """T - w (T - P(T)), P the play operator of half width r and w = width / (2 r): falling reads higher than rising.

    P follows T only when it is pulled: ``P = max(T - r, min(T + r, P before))``. A swing of more than 2 r runs through
    a closed loop, ``width`` high; a smaller one only loses the share w of its swing.

    Parameters
    ----------
    width : float
        Falling minus rising reading of a large loop [N m], >= 0.
    reach : float
        r [N m], > 0 and at least half of ``width``: half the swing after which the loop is fully open.

    Notes
    -----
    Source: handbook 6.6; play operator: Visintin, Differential Models of Hysteresis, ch. III; one element of the
    Prandtl-Ishlinskii sum. Rate-independent: creep of the measuring body is not modelled. A loop of area
    2 width (A - r) for a swing from -A to A.
    """

    width: float
    reach: float

    def __post_init__(self) -> None:
        if not (self.reach > 0 and 0 <= self.width <= 2 * self.reach):
            raise InputError(
                f"a hysteresis {self.width} N*m wide with a reach of {self.reach} N*m cannot be; "
                "the reach must be above 0 N*m and at least half of the width"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel lagging."""
        if self.width == 0:
            return recording
        name = recording.torque_name()
        channel = recording.channels[name]
        torque = channel.in_si()
        lag = torque - _play(torque, self.reach)
        return recording.with_values(name, channel.values - self.width / (2 * self.reach) * lag / channel.si_per_unit)


def _play(values: NDArray[np.float64], reach: float) -> NDArray[np.float64]:
    """Return the play operator's output, started in the middle of its play at the first value, shape (samples,)."""
    followed = []
    at = float(values[0]) if values.size else 0.0
    for value in values.tolist():
        at = max(value - reach, min(value + reach, at))
        followed.append(at)
    return np.array(followed)
