"""Mean torque that the loads of a rig demand at its measured shaft."""

from __future__ import annotations

from dataclasses import replace
from math import copysign

from torquerig.rig.assembly import Rig
from torquerig.rig.leading_part import leading_motor
from torquerig.rig.steady import steady_torque
from torquerig.scenario.kinematics import torque_gain


def mean_load(rig: Rig) -> float:
    """Return the mean torque of all loads and friction but the motor's own at the operating point [N m].

    Each counts at its own speed and is referred to the measured shaft by the ratios and efficiencies between, also on
    branches and before the sensor: over the torque gain of the chain, it is what the motor must give. Zero for a rig
    without a motor or a speed.
    """
    motor = leading_motor(rig)
    if motor is None or not rig.run.speed:
        return 0.0
    free = rig.changed(replace(motor, viscous=0.0, coulomb=0.0))
    return copysign(1.0, rig.run.speed) * steady_torque(free, motor.name) * torque_gain(rig)
