"""Linear response of a train: what a torque at a mass, or an angle error in a spring, makes at the sensor."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from proof.fleet.train import Train

Complex = NDArray[np.complex128]


def sensed_per_torque(train: Train, frequency: float, mass: int, *, speed: float) -> complex:
    """Return the sensed torque per torque on a mass [1], both complex, in the output shaft's coordinates.

    ``speed`` is the output speed [rad/s] at which quadratic drag is linearised.
    """
    force = np.zeros(train.inertia.size, dtype=complex)
    force[mass] = 1.0
    return _sensed(train, frequency, force, speed=speed)


def sensed_per_error(train: Train, frequency: float, spring: int, *, speed: float) -> complex:
    """Return the sensed torque per angle error in a spring [N m/rad]."""
    s = 2j * np.pi * frequency
    pull = train.stiffness[spring] + s * train.damping[spring]
    force = np.zeros(train.inertia.size, dtype=complex)
    force[spring], force[spring + 1] = -pull, pull
    return _sensed(train, frequency, force, speed=speed) + (pull if spring == train.sensor_spring else 0.0)


def _sensed(train: Train, frequency: float, force: Complex, *, speed: float) -> complex:
    s = 2j * np.pi * frequency
    masses = train.inertia.size
    matrix = np.diag(s * s * train.inertia + s * train.viscous).astype(complex)
    for j in range(masses - 1):
        pull = train.stiffness[j] + s * train.damping[j]
        matrix[np.ix_([j, j + 1], [j, j + 1])] += pull * np.array([[1.0, -1.0], [-1.0, 1.0]])
    matrix[-1, -1] += s * 2.0 * train.drag * abs(speed)
    lag = train.lag / (train.lag + s)
    if train.induction:
        slope = 2.0 * train.breakdown_torque / train.breakdown_slip * lag
        matrix[0, 0] += s * slope * train.ratio**2
    else:
        matrix[0, 0] += s * (train.kp + train.ki / s) * lag * train.ratio**2
    if train.branch_inertia:
        pull = train.branch_stiffness + s * train.branch_damping
        matrix[-1, -1] += pull * s * s * train.branch_inertia / (s * s * train.branch_inertia + pull)
    angles = np.linalg.solve(matrix, force)
    j = train.sensor_spring
    return complex((train.stiffness[j] + s * train.damping[j]) * (angles[j] - angles[j + 1]))
