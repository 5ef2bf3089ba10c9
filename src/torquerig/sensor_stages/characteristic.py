"""Nonlinear characteristic and gain error of a sensor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Characteristic:
    """T (1 + e + n x + m x^2) with x = T / full scale.

    Parameters
    ----------
    full_scale : float
        [N m], > 0.
    gain_error, quadratic, cubic : float
        e, n and m: what each adds to the reading at full scale, as a share of full scale [1].

    Notes
    -----
    Source: handbook 6.5, 6.13 (DIN 51309). A sine of amplitude A gets a second harmonic n A^2 / (2 full scale), a
    third m A^3 / (4 full scale^2), and a mean n A^2 / (2 full scale). Not valid far beyond full scale.
    """

    full_scale: float
    gain_error: float = 0.0
    quadratic: float = 0.0
    cubic: float = 0.0

    def __post_init__(self) -> None:
        if not self.full_scale > 0:
            raise InputError(f"a sensor with a full scale of {self.full_scale} N*m cannot be; write more than 0 N*m")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel through the characteristic."""
        if not (self.gain_error or self.quadratic or self.cubic):
            return recording
        name = recording.torque_name()
        channel = recording.channels[name]
        share = channel.values * (channel.si_per_unit / self.full_scale)
        factor = 1 + self.gain_error + share * (self.quadratic + self.cubic * share)
        return recording.with_values(name, channel.values * factor)
