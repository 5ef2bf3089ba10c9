"""A shaft with imposed motion: as measured, or by the profile of the run, with any torque that this needs."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig import terms
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.recorded_input import check_source, recorded_motion, wanted_channel


@dataclass(frozen=True, kw_only=True)
class ImposedMotion(Part):
    """Angle and speed of the shaft of ``at`` are ``factor channel(t)``; the required torque is ``true_NAME_torque_Nm``.

    Between samples the angle is a cubic; before the recording its first speed is held. A rig with one needs no drive.
    Not true for an angle in coarse counts: they are smoothed over 16 counts, and what is faster is lost.

    Parameters
    ----------
    recording : path, optional
        As the scenario writes it, from its own folder; without one the run's set-point of speed is imposed.
    from : "channel" or "channel NAME", optional
        In place of ``recording``: the channel of each recording that is simulated or diagnosed.
    channel : str
        By name or by quantity: an angle, position, speed or velocity.
    """

    kind: Literal["imposed_motion"] = "imposed_motion"
    at: str = "motor"
    recording: Path | None = None
    from_: str | None = None
    channel: str = "motor_speed"
    factor: Annotated[float, Parameter("1", "multiplies the channel, or the set-point; -1 turns it round")] = 1.0

    def __post_init__(self) -> None:
        check_source(recording=self.recording, from_=self.from_, channel=self.channel, usual="motor_speed")

    @property
    def wanted(self) -> str:
        """The channel of each recording, by name or quantity."""
        return self.channel if self.from_ is None else wanted_channel(self.from_, self.channel)

    def terms(self, rig: Rig) -> tuple[terms.Term, ...]:
        """Return the motion."""
        node = rig.node(self.at)
        motion = recorded_motion(
            rig, self, at=self.at, recording=self.recording, from_=self.from_, channel=self.channel, factor=self.factor
        )
        return (terms.ImposedMotion(name=self.name, on=node, motion=motion, factor=self.factor),)
