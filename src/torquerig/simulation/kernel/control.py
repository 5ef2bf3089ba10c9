"""Measured speed and command of the drives, once a sample."""

from __future__ import annotations

from numba import njit

from torquerig.simulation.kernel.choice import any_of, floor, where
from torquerig.simulation.kernel.elementary import exponential, sine_cosine
from torquerig.simulation.kernel.fast import FAST


@njit(fastmath=FAST, inline="always")
def sensed(sensings, i, sample, angle, speed, period, seen_angle, seen_speed):
    """Return the speed that the drive ``i`` sees: from the angle that it reads now and read a sample before."""
    reading = angle
    for j in range(sensings.first[i], sensings.first[i + 1]):
        sine, cosine = sine_cosine(sensings.order[j] * angle)
        reading += sensings.c[j] * cosine - sensings.s[j] * sine
    if any_of(sensings.step[i] > 0.0):
        reading = floor(reading / sensings.step[i]) * sensings.step[i]
    if sample == 0:  # before the run it turned on as it does now
        seen_speed[i] = speed
    else:
        share = 1.0
        if any_of(sensings.filter_time[i] > 0.0):
            share = 1.0 - exponential(-period / sensings.filter_time[i])
        seen_speed[i] += share * ((reading - seen_angle[i]) / period - seen_speed[i])
    seen_angle[i] = reading
    return seen_speed[i]


@njit(fastmath=FAST, inline="always")
def control(drives, sensings, sample, now, theta, omega, period, integral, command, seen_angle, seen_speed):
    """Fill ``command``: the demand and the PI on the speed, limited; the integrator holds while limited.

    Set-point and demand of the ``sample`` of the run are in the column ``now``.

    An induction machine has no control: its command is the torque of its slip.
    """
    for i in range(drives.on.size):
        speed = omega[drives.on[i]] - omega[drives.against[i]]
        if not sensings.ideal[i]:
            angle = theta[drives.on[i]] - theta[drives.against[i]]
            speed = sensed(sensings, i, sample, angle, speed, period, seen_angle, seen_speed)
        error = drives.reference[i, now] - speed
        if any_of(drives.breakdown[i] > 0.0):
            slip = error / drives.breakdown[i]
            command[i] = 2.0 * drives.limit[i] * slip / (1.0 + slip * slip)
            continue
        grown, limit = integral[i] + error * period, drives.limit[i]
        wish = drives.demand[i, now] + drives.kp[i] * error + drives.ki[i] * grown
        within = abs(wish) <= limit
        integral[i] = where(within, grown, integral[i])
        command[i] = where(within, wish, where(wish > 0.0, limit, -limit))
