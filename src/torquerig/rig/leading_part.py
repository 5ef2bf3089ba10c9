"""The part of a rig that its set-point of the speed belongs to."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.parts import ImposedMotion, InductionDrive, Motor, SpeedController, TorqueController


def leading_part(rig: Rig) -> str | None:
    """Return the name of the driven motor, else of the part that is moved, else of the first motor; None without."""
    driven: tuple[SpeedController | InductionDrive | TorqueController, ...] = (
        *rig.parts_of(SpeedController), *rig.parts_of(InductionDrive), *rig.parts_of(TorqueController),
    )  # fmt: skip
    names = [part.motor for part in driven] + [part.at for part in rig.parts_of(ImposedMotion)]
    names += [part.name for part in rig.parts_of(Motor)]
    return names[0] if names else None


def leading_motor(rig: Rig) -> Motor | None:
    """Return the motor that the set-point belongs to; else the first motor of the rig; None without one."""
    motors = rig.parts_of(Motor)
    leader = leading_part(rig)
    return next((motor for motor in motors if motor.name == leader), motors[0] if motors else None)
