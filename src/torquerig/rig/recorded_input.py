"""A part whose torque or motion is recorded: in a file, or in a channel of the recording that is simulated."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.inputs import Inputs
from torquerig.recordings.replay import ReplayedMotion, ReplayedTorque, recording_at, replayed_motion, replayed_torque
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import Motion, Signal

Floats = NDArray[np.float64]

AnySignal = TypeVar("AnySignal", ReplayedTorque, ReplayedMotion)

_FROM = "channel"
_OF_A_LINE = ("force", "position", "velocity")
_OF_A_SHAFT = ("torque", "motor_torque", "angle", "motor_angle", "speed", "motor_speed")


@dataclass(frozen=True)
class Unbound:
    """The signal of a part that takes a channel of each recording, while there is no recording."""

    part: str

    def at(self, time: Floats) -> Floats:
        """Raise InputError: nothing is known of the signal."""
        raise self.error()

    def error(self) -> InputError:
        """Return the sentence that the part has no recording, with the remedy."""
        return InputError(
            f"{self.part} takes a channel of each recording (from: channel), and there is none; name one with --inputs "
            "RECORDING (in Python inputs=)"
        )


@dataclass(frozen=True)
class UnboundMotion(Unbound):
    """The same of a motion."""

    def at(self, time: Floats) -> tuple[Floats, Floats]:  # type: ignore[override]
        """Raise InputError: nothing is known of the motion."""
        raise self.error()


def wanted_channel(from_: str, channel: str) -> str:
    """Return the channel that ``from: channel NAME`` names, else ``channel``."""
    return from_.removeprefix(_FROM).strip() or channel


def check_source(*, recording: Path | None, from_: str | None, channel: str, usual: str, needed: bool = False) -> None:
    """Raise ValueError for a ``from`` that is no channel, and where it contradicts what else is stated."""
    if from_ is None:
        if needed and recording is None:
            raise ValueError("neither recording: nor from: is stated; write recording: FILE, or from: channel NAME")
        return
    if from_.split(" ")[0] != _FROM:
        raise ValueError(f"from is {from_!r}; write from: channel NAME, with the name or quantity of a channel")
    if recording is not None:
        raise ValueError("both recording: and from: are stated; keep one: a file, or a channel of each recording")
    if from_.strip() != _FROM and channel != usual:
        raise ValueError(
            f"from names the channel {wanted_channel(from_, channel)!r}, and channel: {channel!r}; keep one"
        )


def recorded_torque(
    rig: Rig, part: Part, *, at: str, recording: Path | None, from_: str | None, channel: str, factor: float,
    torque_constant: float | None,
) -> Signal | None:  # fmt: skip
    """Return the torque that a part replays; None where it states none; unbound where the run has no inputs."""
    if from_ is not None:
        inputs = rig.run.inputs
        if not isinstance(inputs, Inputs):
            return Unbound(part.name)
        wanted = wanted_channel(from_, channel)
        made = inputs.torque(wanted, at=at, factor=factor, torque_constant=torque_constant)
        return _of_its_kind(made, rig, at)
    if recording is None:
        return None
    read = recording_at(recording)
    return _of_its_kind(replayed_torque(read, channel, factor=factor, torque_constant=torque_constant), rig, at)


def recorded_motion(
    rig: Rig, part: Part, *, at: str, recording: Path | None, from_: str | None, channel: str, factor: float
) -> Motion | None:  # fmt: skip
    """Return the motion that a part imposes; None for the set-point of the run; unbound where it has no inputs."""
    if from_ is not None:
        inputs = rig.run.inputs
        if not isinstance(inputs, Inputs):
            return UnboundMotion(part.name)
        return _of_its_kind(inputs.motion(wanted_channel(from_, channel), at=at, factor=factor), rig, at)
    if recording is None:
        return None
    return _of_its_kind(replayed_motion(recording_at(recording), channel, factor=factor), rig, at)


def _of_its_kind(made: AnySignal, rig: Rig, at: str) -> AnySignal:
    """Return a signal as it is; InputError for a force on a shaft, and for a torque on a part that moves in a line."""
    in_a_line = rig.part(at).in_a_line
    if made.quantity in (_OF_A_SHAFT if in_a_line else _OF_A_LINE):
        needs = "a force, a position or a velocity" if in_a_line else "a torque, an angle or a speed"
        moves = "moves in a line" if in_a_line else "turns"
        raise InputError(
            f"{made.label} is a {made.quantity}, and {at!r} {moves}: it needs {needs}; name another channel, or state "
            "its quantity and scale in the sidecar (a force times its lever arm is a torque)"
        )
    return made
