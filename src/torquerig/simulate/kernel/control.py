"""What the drives see and command, once a sample."""

from __future__ import annotations

import numpy as np
from numba import njit

from torquerig.simulate.kernel.direction import FAST


@njit(fastmath=FAST, inline="always")
def sensed(sensings, i, sample, angle, speed, period, seen_angle, seen_speed):
    """Return the speed that the drive ``i`` sees: from the angle that it reads now and read a sample before."""
    reading = angle
    for j in range(sensings.first[i], sensings.first[i + 1]):
        wave = sensings.order[j] * angle
        reading += sensings.c[j] * np.cos(wave) - sensings.s[j] * np.sin(wave)
    if sensings.step[i] > 0.0:
        reading = np.floor(reading / sensings.step[i]) * sensings.step[i]
    if sample == 0:  # before the run it turned on as it does now
        seen_speed[i] = speed
    else:
        share = 1.0
        if sensings.filter_time[i] > 0.0:
            share = 1.0 - np.exp(-period / sensings.filter_time[i])
        seen_speed[i] += share * ((reading - seen_angle[i]) / period - seen_speed[i])
    seen_angle[i] = reading
    return seen_speed[i]


@njit(fastmath=FAST, inline="always")
def control(drives, sensings, sample, theta, omega, period, integral, command, seen_angle, seen_speed):
    """Fill ``command``: the demand and the PI on the speed, limited; the integrator holds while limited.

    An induction machine has no control: its command is the torque of its slip.
    """
    for i in range(drives.on.size):
        speed = omega[drives.on[i]] - omega[drives.against[i]]
        if not sensings.ideal[i]:
            angle = theta[drives.on[i]] - theta[drives.against[i]]
            speed = sensed(sensings, i, sample, angle, speed, period, seen_angle, seen_speed)
        error = drives.reference[i, sample] - speed
        if drives.breakdown[i] > 0.0:
            slip = error / drives.breakdown[i]
            command[i] = 2.0 * drives.limit[i] * slip / (1.0 + slip * slip)
            continue
        wish = drives.demand[i, sample] + drives.kp[i] * error + drives.ki[i] * (integral[i] + error * period)
        if abs(wish) <= drives.limit[i]:
            integral[i] += error * period
            command[i] = wish
        else:
            command[i] = drives.limit[i] if wish > 0.0 else -drives.limit[i]
