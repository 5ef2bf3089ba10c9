"""Whether the recordings of one call can be runs of the scenario's rig, before anything is computed."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import (
    ImposedMotion,
    InductionDrive,
    Motor,
    ReactionTorqueSensor,
    SpeedController,
    TorqueController,
)


def check_rig(rig: Rig) -> None:
    """Raise where nothing drives the scenario's rig, or what is measured has no spring."""
    driven = any(rig.parts_of(drive) for drive in (SpeedController, TorqueController, InductionDrive))
    imposed = next(iter(rig.parts_of(ImposedMotion)), None)
    if imposed is not None and not driven:
        raise InputError(
            f"the scenario imposes the motion {imposed.name!r} but measures {rig.measured!r}; write from: channel NAME "
            f"into {imposed.name}, so that each recording states its motion, or measured: {imposed.name}, or add a "
            "speed_controller that drives the motor"
        )
    if not driven and not rig.parts_of(Motor):
        raise InputError(
            "the rig has no motor, and nothing states how it moves; record the position or velocity of the part that "
            "is pushed, add motion: {kind: imposed_motion, at: PART, from: channel NAME} for it, and write measured: "
            "motion to compare the force that moves it, or measured: SENSOR for a sensor behind it"
        )
    if not driven:
        raise InputError(
            "nothing in the scenario drives a motor; add a speed_controller, for a recorded torque of the motor a "
            "torque_controller with from: channel NAME, or for a recorded motion an imposed_motion with from: channel "
            "NAME, or one named under measured:"
        )
    if isinstance(rig.part(rig.measured), ReactionTorqueSensor):
        raise InputError(
            f"the scenario compares {rig.measured!r}, the torque at a motor's foot, which no diagnosis explains yet; "
            "name the torque_sensor, coupling or gear to compare first under measured:"
        )
    if not rig.part(rig.measured).opens_node:
        raise InputError(
            f"the scenario measures {rig.measured!r}, which transmits no torque; name a torque_sensor, a coupling or a "
            "gear under measured:"
        )


def check_recordings(recordings: Sequence[Recording]) -> None:
    """Raise where a recording has no torque, or the sheets state several motors."""
    for recording in recordings:
        recording.torque_name()
    motors = {recording.run.motor for recording in recordings if recording.run.motor}
    if len(motors) > 1:
        raise InputError(
            f"the recordings are of different rigs: their sidecars state the motor as {' and '.join(sorted(motors))}; "
            "diagnose the runs of one rig in one call"
        )
