"""State in which a run starts, time until it is recorded, and steps of the integration."""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from proof.fleet.courses import Courses
from proof.fleet.train import Train

Floats = NDArray[np.float64]
STEP_TIMES_FASTEST = 0.6  # step times fastest rate; the rule then adds 0.0005 to the damping ratio of that mode


def settling_time(train: Train) -> float:
    """Return the time [s] that a run needs before its recording: three of the speed loop's slowest periods."""
    if train.induction:
        return 0.8
    whole = train.inertia.sum() / train.ratio**2
    corner = min(train.kp / whole, train.ki / train.kp)
    return float(np.clip(5.0 / corner, 0.5, 3.0))


def substeps_of(train: Train, frame_rate: float) -> int:
    """Return the integration steps in a frame, from the train's fastest mode, damper and friction slope."""
    springs, masses = train.stiffness.size, train.inertia.size
    stiffness = np.zeros((masses, masses))
    for j in range(springs):
        pair = np.ix_([j, j + 1], [j, j + 1])
        stiffness[pair] += train.stiffness[j] * np.array([[1.0, -1.0], [-1.0, 1.0]])
    scaled = stiffness / np.sqrt(np.outer(train.inertia, train.inertia))
    fastest = np.sqrt(np.linalg.eigvalsh(scaled)[-1])
    damper = (train.damping / train.inertia[:-1] + train.damping / train.inertia[1:]).max()
    dry = train.contact_torque + train.dry.max() + train.peak.max()
    friction = dry / train.friction_width / train.inertia[-1] if train.friction != 1 else 1.0 / train.bristle_angle
    if train.peak.max() > 0:
        friction += train.peak.max() / train.stribeck_speed / train.inertia[-1]
    branch = np.sqrt(train.branch_stiffness / train.branch_inertia) if train.branch_inertia else 0.0
    rates = (fastest, damper, friction, 2.0 * branch, train.lag)
    return int(np.clip(np.ceil(max(rates) / STEP_TIMES_FASTEST / frame_rate), 1, 60))


def start_state(train: Train, courses: Courses) -> Floats:
    """Return the state of steady motion at the first set-point: twists, speeds and motor torque."""
    masses = train.inertia.size
    speed = courses.set_point[0] / train.ratio
    state = np.zeros(2 * masses + 4)
    motor_torque = 0.0
    for _ in range(20 if train.induction else 1):
        if train.induction:
            over = train.breakdown_torque / max(abs(motor_torque), 1e-12)
            slip = train.breakdown_slip * (over - np.sqrt(max(over**2 - 1.0, 0.0)))
            speed = (courses.set_point[0] - np.sign(motor_torque) * slip) / train.ratio
        state, motor_torque = _twisted(train, courses, speed)
    return state


def _twisted(train: Train, courses: Courses, speed: float) -> tuple[Floats, float]:
    masses = train.inertia.size
    state = np.zeros(2 * masses + 4)
    state[masses : 2 * masses] = speed
    drag = train.drag * speed * abs(speed)
    against = courses.resist[0] + train.dry[0] + float(np.mean(train.blade_table))
    pull = drag + train.viscous[-1] * speed + np.sign(speed) * against
    for j in range(masses - 2, -1, -1):
        gap = np.sign(pull) * train.half_gap[j]
        state[j] = state[j + 1] + pull / train.stiffness[j] + gap
        pull = pull + abs(pull) * train.loss[j] * np.sign(speed) + train.viscous[j] * speed
    motor = pull / train.ratio + train.motor_coulomb * np.sign(speed * train.ratio)
    state[2 * masses], state[2 * masses + 1] = state[masses - 1], speed  # the branch
    state[2 * masses + 2], state[2 * masses + 3] = motor, np.sign(speed)
    return state, float(motor)


def first_mode(train: Train) -> float:
    """Return the lowest torsional frequency of the train with a free motor [Hz]."""
    springs, masses = train.stiffness.size, train.inertia.size
    stiffness = np.zeros((masses, masses))
    for j in range(springs):
        stiffness[np.ix_([j, j + 1], [j, j + 1])] += train.stiffness[j] * np.array([[1.0, -1.0], [-1.0, 1.0]])
    scaled = stiffness / np.sqrt(np.outer(train.inertia, train.inertia))
    return float(np.sqrt(np.linalg.eigvalsh(scaled)[1]) / (2.0 * pi))
