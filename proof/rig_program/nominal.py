"""The reference wear rig, and the deviations of real ones from it.

Each quantity is ``(value, rel_sd)``: the nominal value and the one-sigma log-normal spread of real rigs around it.
"""

from __future__ import annotations

SAMPLE_RATE = 25000.0  # [Hz]
RATIO = 5.0
EFFICIENCY = 0.97
TORQUE_LIMIT = 2.0  # [Nm] of the motor
CURRENT_LOOP = 500.0  # [Hz]
SENSOR_BANDWIDTH = 3000.0  # [Hz], second-order Butterworth
CONVERTER_RANGE = 10.0  # [V]
CONVERTER_BITS = 16
ENCODER_COUNTS = 16384
SETTLING = 1.5  # [s] before a recording begins
MOTOR_COULOMB_WIDTH = 0.5  # [rad/s] of the motor
FRICTION_WIDTH = 0.02  # [rad/s] of the wear part
SPEED_ERROR = 0.01  # largest relative error of the set-point
WANDER = (2.0e-4, 0.3)  # relative sd, low-pass [Hz]
LINE_SPREAD = 0.25  # rel_sd of each line's amplitude
MEAN_LOAD_SPREAD = 0.03  # a real rig's mean load is known to a few per cent
LOAD_LEVELS = ((0.0, 0.05), (5.0, 1.0), (11.0, 2.0), (15.0, 2.7), (21.0, 3.8))  # occupancy [%], mean torque [Nm]
HITS_SHARE = 0.10  # rms of the particle hits, of the mean
SLOW_SHARE = 0.06  # rms of the slow variation, of the mean
SLOW_CORNER = 1.5  # [Hz]

QUANTITIES: dict[str, tuple[float, float]] = {
    "rotor_inertia": (1.5e-4, 0.08),  # [kg m2]
    "motor_viscous": (1.5e-4, 0.3),  # [Nms/rad]
    "motor_coulomb": (0.015, 0.3),  # [Nm]
    "gear_inertia": (7.0e-4, 0.1),  # [kg m2] at the output
    "gear_stiffness": (11300.0, 0.12),  # [Nm/rad] at the output
    "gear_damping": (2.0, 0.3),  # [Nms/rad] at the output
    "sensor_stiffness": (1100.0, 0.03),  # [Nm/rad]
    "sensor_damping": (0.12, 0.3),  # [Nms/rad]
    "sensor_inertia": (4.0e-5, 0.1),  # [kg m2] of its output side
    "noise": (0.005, 0.3),  # [V] rms
    "coupling_stiffness": (6500.0, 0.12),  # [Nm/rad]
    "coupling_damping": (0.4, 0.3),  # [Nms/rad]
    "wear_inertia": (2.0e-3, 0.1),  # [kg m2]
    "wear_viscous": (0.010, 0.3),  # [Nms/rad]
    "kp": (0.05, 0.05),  # [Nms/rad]
    "ki": (0.5, 0.05),  # [Nm/rad]
}

# zero-to-peak [Nm] by order of the motor, at the motor
MOTOR_LINES: dict[int, float] = {
    1: 0.020, 2: 0.008, 3: 0.004, 4: 0.002,
    6: 0.020, 12: 0.008, 18: 0.005, 24: 0.003,
    7: 0.015, 14: 0.006, 21: 0.004, 28: 0.003,
}  # fmt: skip
# zero-to-peak [Nm] by order of the output shaft, at the wear part, idle
WEAR_LINES: dict[int, float] = {1: 0.10, 2: 0.04, 3: 0.02, 4: 0.01}
WEAR_LINES_BY_OCCUPANCY = 0.12  # the wear part's lines are divided by 1 + this * occupancy [%]


def hit_rate(occupancy: float, particle: float) -> float:
    """Hits per second [1/s] at this occupancy [%] with particles of this size [mm]."""
    return float(60.0 * (0.5 / particle) ** 1.5 * (0.3 + occupancy / 10.0))


def hit_decay(particle: float) -> float:
    """Decay time of a hit [s] for particles of this size [mm]."""
    return float(0.004 * (particle / 0.5) ** 0.5)
