"""A measured torque that acts on a shaft once more."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.recorded_input import check_source, recorded_torque
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
    from : "channel" or "channel NAME"
        In place of ``recording``: the channel of each recording that is simulated or diagnosed.
    channel : str
        By name or by quantity: a torque, motor torque or force, or a current with ``torque_constant``.
    """

    kind: Literal["replayed_torque"] = "replayed_torque"
    at: str = "motor"
    recording: Path | None = None
    from_: str | None = None
    channel: str = "motor_torque"
    factor: Annotated[float, Parameter("1", "multiplies the channel; -1 turns it round")] = 1.0
    torque_constant: Annotated[float, Parameter("N*m/A", "torque per current", above=0)] | None = None

    def __post_init__(self) -> None:
        check_source(
            recording=self.recording, from_=self.from_, channel=self.channel, usual="motor_torque", needed=True
        )

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the torque."""
        node = rig.node(self.at)
        signal = recorded_torque(
            rig, self, at=self.at, recording=self.recording, from_=self.from_, channel=self.channel,
            factor=self.factor, torque_constant=self.torque_constant,
        )  # fmt: skip
        return () if signal is None else (AppliedTorque(name=self.name, on=node, process=signal),)
