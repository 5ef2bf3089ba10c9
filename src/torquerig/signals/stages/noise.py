"""What the sensor's own noise adds to its output."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.signals.recording import Recording


@dataclass(frozen=True, kw_only=True)
class WhiteNoise:
    """Gaussian noise, independent from sample to sample: V += rms * n, flat to half the sample rate.

    Parameters
    ----------
    rms : float
        [V], that is in the unit of the torque channel, >= 0.

    Notes
    -----
    Source: handbook 6.7. The same recording seed gives the same noise, whatever other stages draw. Real noise
    has more power at low frequencies and lines of the carrier, which are not in here.
    """

    rms: float

    def __post_init__(self) -> None:
        if not self.rms >= 0:
            raise InputError(f"a noise of {self.rms} V rms cannot be; write 0 V or more")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with noise on its torque channel."""
        name = recording.torque_name()
        values = recording.channels[name].values
        if self.rms == 0:
            return recording
        noise = recording.random("sensor noise").standard_normal(values.size)
        return recording.with_values(name, values + self.rms * noise)
