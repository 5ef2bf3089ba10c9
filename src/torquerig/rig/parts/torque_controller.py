"""A torque demand on a motor: constant, by the profile of the run, or replayed from a recording."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.motor_drive import motor_drive
from torquerig.rig.recorded_input import check_source, recorded_torque
from torquerig.rig.terms import Signal, Term


@dataclass(frozen=True, kw_only=True)
class TorqueController(Part):
    """The motor follows a torque: ``command = clip(torque profile(t) + factor channel(t), +-limit)`` through its lag.

    Alone it is a drive in torque mode: while the rig settles it is held at its set-point of speed (at rest where none
    is stated) and then let go. With ``beside`` the demand is fed forward into that speed controller.

    Parameters
    ----------
    recording : path, optional
        As the scenario writes it, from its own folder.
    from : "channel" or "channel NAME", optional
        In place of ``recording``: the channel of each recording that is simulated or diagnosed.
    channel : str
        Of the recording, by name or by quantity: a motor torque, a torque, or a current with ``torque_constant``.
    """

    kind: Literal["torque_controller"] = "torque_controller"
    motor: str = "motor"
    torque: Annotated[float, Parameter("N*m", "torque at the top of the profile")] = 0.0
    recording: Path | None = None
    from_: str | None = None
    channel: str = "motor_torque"
    factor: Annotated[float, Parameter("1", "multiplies the channel; -1 turns it round")] = 1.0
    torque_constant: Annotated[float, Parameter("N*m/A", "torque per current", above=0)] | None = None
    beside: str | None = None

    def __post_init__(self) -> None:
        check_source(recording=self.recording, from_=self.from_, channel=self.channel, usual="motor_torque")

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the drive in torque mode; none where a speed controller takes the demand."""
        if self.beside is not None:
            rig.part(self.beside)
            return ()
        return (motor_drive(rig, self.name, motor=self.motor, torque=self.torque, demand=self.demand(rig)),)

    def demand(self, rig: Rig) -> Signal | None:
        """Return what is replayed; None where nothing is."""
        return recorded_torque(
            rig, self, at=self.motor, recording=self.recording, from_=self.from_, channel=self.channel,
            factor=self.factor, torque_constant=self.torque_constant,
        )  # fmt: skip
