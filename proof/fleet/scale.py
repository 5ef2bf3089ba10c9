"""Size of a rig: rated torque and speeds, inertia of the load, stiffness of its coupling; all else follows."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

RPM = 2.0 * pi / 60.0
MOST_POWER = 60e3  # [W] of a drive on a test bench


@dataclass(frozen=True)
class Scale:
    """Rated values of a rig in SI units.

    Parameters
    ----------
    torque : float
        Mean torque at the sensor at full load [N m].
    motor_speed : float
        Rated speed of the motor, or of its field [rad/s].
    output_speed : float
        Rated speed of the output shaft [rad/s].
    ratio : float
        Motor turns per output turn, positive.
    inertia : float
        Of the loading body [kg m^2].
    stiffness : float
        Of the coupling in front of it [N m/rad].
    damping : float
        Damping ratio of a spring and the mass behind it.
    """

    torque: float
    motor_speed: float
    output_speed: float
    ratio: float
    inertia: float
    stiffness: float
    damping: float


RATIOS = {"direct": 1.0, "belt": 2.0, "one_stage": 4.0, "two_stage": 12.0, "three_stage": 30.0, "worm": 30.0}


def draw_scale(rng: np.random.Generator, *, motor_kind: str, drive: str, load_kind: str) -> Scale:
    """Draw the size of a rig: 0.01 to 1000 N m, as far as its power stays below that of a test bench."""
    if motor_kind == "induction":
        motor_speed = float(rng.choice([1000.0, 1500.0, 3000.0])) * RPM
    else:
        motor_speed = round(float(10.0 ** rng.uniform(2.6, 3.5)) / 20.0) * 20.0 * RPM
    ratio = RATIOS[drive]  # of the design; the stages have their own teeth
    output_speed = motor_speed / ratio
    torque = float(10.0 ** rng.uniform(-2.0, 3.0))
    torque = min(torque, MOST_POWER / output_speed)
    acceleration = float(10.0 ** rng.uniform(1.5, 2.6))
    inertia = torque / acceleration
    frequency = float(10.0 ** rng.uniform(1.3, 2.0))
    return Scale(
        torque=torque,
        motor_speed=motor_speed,
        output_speed=output_speed,
        ratio=ratio,
        inertia=inertia,
        stiffness=inertia * (2.0 * pi * frequency) ** 2,
        damping=float(rng.uniform(0.01, 0.04)),
    )
