"""True scale and constant zero of a sensor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class ScaleAndZero:
    """V = scale V + zero / |SI per V|: the sensitivity is off by a factor, and no load reads as ``zero``.

    Parameters
    ----------
    scale : float
        True sensitivity over the stated one [1], > 0.
    zero : float
        Reading without a load, in the sense of the sensor, in the SI unit of its quantity (N m, N, rad/s ...).

    Notes
    -----
    Source: DIN 51309 and JCGM 200:2012, 4.12 (sensitivity) and 4.28 (zero error). Both are constant over a run; a zero
    that moves is a ``sensor_drift``, a curved characteristic a ``sensor_nonlinearity``.
    """

    scale: float = 1.0
    zero: float = 0.0

    def __post_init__(self) -> None:
        if not self.scale > 0:
            raise InputError(
                f"a scale of {self.scale} cannot be; write more than 0, and mounting: reversed for a sensor that is "
                "turned round"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel scaled and shifted."""
        name = recording.torque_name()
        channel = recording.channels[name]
        return recording.with_values(name, self.scale * channel.values + self.zero / abs(channel.si_per_unit))
