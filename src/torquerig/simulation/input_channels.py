"""The measured inputs of a simulated run: bound to a rig, and as channels of its recording."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.channel_angle import unsmoothed_angle_of
from torquerig.recordings.inputs import Inputs, input_channel
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.replay import ANGLES, ReplayedTorque
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import ImposedMotion, TorqueController
from torquerig.rig.parts import ReplayedTorque as ReplayedPart
from torquerig.rig.recorded_input import wanted_channel
from torquerig.simulation.input_noise import noisy_speed

DrivenPart = ImposedMotion | ReplayedPart | TorqueController


def driven_parts(rig: Rig) -> tuple[DrivenPart, ...]:
    """Return the parts that take a channel of each recording, in their order."""
    parts = (part for part in rig.parts if isinstance(part, ImposedMotion | ReplayedPart | TorqueController))
    return tuple(part for part in parts if part.from_ is not None)


def channel_of(part: DrivenPart, recording: Recording) -> str:
    """Return the name of the channel that drives a part; RecordingError where there is none, or no single one."""
    at = part.motor if isinstance(part, TorqueController) else part.at
    return input_channel(recording, wanted_channel(part.from_ or "", part.channel), at=at)


def with_inputs(rig: Rig, recording: Recording) -> Rig:
    """Return the rig driven by the channels of a recording; its set-points stay those of the rig.

    Raises
    ------
    InputError
        Where no part takes a channel.
    """
    if not driven_parts(rig):
        raise InputError(
            f"no part of the scenario takes a channel of {recording.name}; write from: channel NAME into an "
            "imposed_motion, replayed_torque or torque_controller, or leave the inputs out"
        )
    return rig.at(replace(rig.run, inputs=Inputs(replace(recording, run=replace(recording.run, inputs=None)))))


def with_input_channels(recording: Recording, rig: Rig) -> Recording:
    """Return a simulated recording with the channels that drove it, role: input, at its sample rate.

    ``origin["warnings"]`` states where the steps of a position put noise into the speed.
    """
    if not isinstance(rig.run.inputs, Inputs):
        return recording
    given, time = rig.run.inputs.recording, recording.time()
    for part in driven_parts(rig):
        name = channel_of(part, given)
        kept = name if name not in recording.channels else f"input_{name}"
        channel = given.channels[name]
        values = _at(channel, given, time, recording.sample_rate)
        recording = recording.with_channel(kept, replace(channel, values=values, role="input"))
        if isinstance(part, ImposedMotion) and (noise := noisy_speed(channel, given.sample_rate, name=name)):
            warnings = [*recording.origin.get("warnings", ()), noise]
            recording = replace(recording, origin={**recording.origin, "warnings": warnings})
    return recording


def _at(channel: Channel, given: Recording, time: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
    """Return the samples of a channel, in its unit, at the times [s] of another recording."""
    if abs(rate / given.sample_rate - 1) < 1e-12:
        return channel.values[: time.size]
    values = unsmoothed_angle_of(channel) / channel.si_per_unit if channel.quantity in ANGLES else channel.values
    return ReplayedTorque(values, given.sample_rate, given.name).at(time)
