"""Pulses of a tacho: a toothed wheel, a reflector or a slotted disc on a shaft."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.recording import Channel
from torquerig.recordings.tacho_edges import PER_MOTOR_TURN

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

_SAMPLES_PER_PULSE = 3.0  # at two a pulse its high and its low part are no longer both seen


@dataclass(frozen=True, kw_only=True)
class Tacho:
    """Adds the channel ``channel``, high for ``duty`` of each pulse; the torque is not changed.

    Parameters
    ----------
    pulses_per_motor_turn : float
        [1/rev], > 0.
    high : float
        Level of a pulse [V]; its low level is 0.
    duty : float
        Share of a pulse that is high [1], 0 to 1.
    angle : str
        Name of the channel with the true motor angle [rad].
    channel : str
        Name of the channel to add.

    Notes
    -----
    The pulses have no direction, and their edges are at samples: an edge is uncertain by one sample.
    """

    pulses_per_motor_turn: float
    high: float = 5.0
    duty: float = 0.5
    angle: str = "true_motor_angle_rad"
    channel: str = "tacho"

    def __post_init__(self) -> None:
        if not (self.pulses_per_motor_turn > 0 and 0 < self.duty < 1):
            raise InputError(
                f"a tacho of {self.pulses_per_motor_turn:g} pulses per turn and a duty of {self.duty:g} cannot be; "
                "write more than 0 pulses, and a duty between 0 and 1"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the pulses; RecordingError where the sample rate is too low for them."""
        pulses = recording.channel(self.angle).in_si() * self.pulses_per_motor_turn / (2 * np.pi)
        fastest = float(np.abs(np.diff(pulses)).max(initial=0.0))
        if fastest * _SAMPLES_PER_PULSE > 1:
            raise RecordingError(
                f"{self.channel}: its pulses come at up to {fastest * recording.sample_rate:.4g} Hz, which "
                f"{recording.sample_rate:g} samples a second do not resolve; use fewer pulses, or a higher sample rate"
            )
        values = np.where(np.mod(pulses, 1.0) < self.duty, self.high, 0.0)
        made = recording.with_channel(self.channel, Channel(values=values, quantity="tacho", unit="V"))
        others = {**made.run.others, PER_MOTOR_TURN: self.pulses_per_motor_turn}
        return replace(made, run=replace(made.run, others=others))
