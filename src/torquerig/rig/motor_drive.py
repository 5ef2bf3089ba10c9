"""The drive of a motor with its controllers, encoder and effects."""

from __future__ import annotations

from dataclasses import replace
from math import pi

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.host_changes import DriveRipple, waves_of
from torquerig.rig.parts.encoder import MotorEncoder, encoder_errors
from torquerig.rig.parts.motor import Motor
from torquerig.rig.terms import Drive, Sensing, Signal


def motor_drive(
    rig: Rig, name: str, *, motor: str, kp: float = 0.0, ki: float = 0.0, torque: float = 0.0,
    demand: Signal | None = None,
) -> Drive:  # fmt: skip
    """Return the drive of the motor ``motor`` by the controller ``name``, with the motor's limit and lag.

    Ripple and errors of the encoder come from the effects of the rig, the sensing of the speed from the encoder that
    names the controller.

    Raises
    ------
    InputError
        Where ``motor`` is no motor, the demand is above its limit, two encoders feed the controller, or an encoder and
        an effect both state its angle error.
    """
    part = rig.part(motor)
    if not isinstance(part, Motor):
        raise InputError(f"{name}: motor: {motor!r} is no motor; name one")
    if abs(torque) > part.torque_limit:
        raise InputError(
            f"{name}: {torque:g} N*m are demanded, and the drive of {motor!r} gives at most {part.torque_limit:g} N*m; "
            "demand less, or raise its torque_limit"
        )
    return Drive(
        name=name,
        on=rig.node(motor),
        kp=kp,
        ki=ki,
        torque_limit=part.torque_limit,
        lag=1 / (2 * pi * part.current_loop_bandwidth),
        ripple=waves_of(rig.changes_in(motor), DriveRipple),
        torque=torque,
        demand=demand,
        sensing=_sensing(rig, name, motor),
    )


def _sensing(rig: Rig, controller: str, motor: str) -> Sensing:
    encoders = [part for part in rig.parts_of(MotorEncoder) if part.controller == controller]
    if len(encoders) > 1:
        names = " and ".join(part.name for part in encoders)
        raise InputError(f"{controller}: {names} both feed it; leave controller: out of one")
    added = encoder_errors(rig, rig.node(motor))
    for part in rig.parts_of(MotorEncoder):
        for name in [name for name, waves in added.items() if waves and part.controller in ("", controller)]:
            if any(part.angle_error.values()):
                raise InputError(
                    f"{name}: {part.name} has an angle_error already, and the encoder on {motor!r} would err twice; "
                    "leave one of the two out"
                )
    sensing = encoders[0].sensing() if encoders else Sensing()
    return replace(sensing, error=(*sensing.error, *(wave for waves in added.values() for wave in waves)))
