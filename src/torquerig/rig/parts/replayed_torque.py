"""A measured torque that acts on a shaft once more."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.recordings.replay import recording_at, replayed_torque
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import AppliedTorque, Term


@dataclass(frozen=True, kw_only=True)
class ReplayedTorque(Part):
    """``factor channel(t)`` on the shaft of ``at``, linear between samples, without limit or lag.

    Positive speeds the shaft up: a load that was recorded as opposing takes a factor of -1, one from behind a gear
    its ratio. Without a speed controller the rig is held at its set-point of speed while it settles. It cannot
    react: a torque that came of the rig's own motion (friction, a loop) comes as it was recorded.

    Parameters
    ----------
    recording : path
        As the scenario writes it, from its own folder.
    channel : str
        By name or by quantity: a torque, motor torque or force, or a current with ``torque_constant``.
    """

    kind: Literal["replayed_torque"] = "replayed_torque"
    at: str = "motor"
    recording: Path
    channel: str = "motor_torque"
    factor: Annotated[float, Parameter("1", "multiplies the channel; -1 turns it round")] = 1.0
    torque_constant: Annotated[float, Parameter("N*m/A", "torque per current", above=0)] | None = None

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the torque."""
        signal = replayed_torque(
            recording_at(self.recording), self.channel, factor=self.factor, torque_constant=self.torque_constant
        )
        return (AppliedTorque(name=self.name, on=rig.node(self.at), process=signal),)
