"""Motors with their drives, as a scenario states them: servo, BLDC, induction motor on its inverter."""

from __future__ import annotations

from math import pi

import numpy as np

from proof.fleet.scale import RPM, Scale
from proof.fleet.stated import Parts, Stated

SERVO_MACHINES = ((4, 12), (5, 12), (3, 9), (4, 9), (5, 18))  # pole pairs, slots
BLDC_MACHINES = ((7, 12), (4, 6), (10, 12), (2, 6))


def state_motor(rng: np.random.Generator, kind: str, name: str, scale: Scale, *, ratio: float) -> Parts:
    """Return the motor, its controller or supply, and its lines."""
    turns = abs(ratio)
    rated = scale.torque / turns  # [N m] at the motor
    inertia = scale.inertia / turns**2 * float(10.0 ** rng.uniform(-0.5, 0.4))
    motor = {
        "kind": "motor",
        "inertia": Stated(inertia, "kg*m^2", float(rng.choice([0.05, 0.1]))),
        "viscous": Stated(0.02 * rated / scale.motor_speed, "N*m*s/rad", 0.3),
        "coulomb": Stated(rated * float(rng.uniform(0.01, 0.03)), "N*m", 0.3),
        "torque_limit": f"{4.0 * rated:.6g} N*m",
    }
    if kind == "induction":
        return {name: motor | {"pole_pairs": _pole_pairs(scale)}, "supply": _supply(rng, name, scale, rated),
                "motor_lines": _lines(rng, name, rated, (1, 2))}  # fmt: skip
    pole_pairs, slots = (SERVO_MACHINES, BLDC_MACHINES)[kind == "bldc"][int(rng.integers(4))]
    motor |= {"pole_pairs": pole_pairs, "slots": slots}
    motor["current_loop_bandwidth"] = f"{rng.choice([300.0, 500.0, 800.0]):g} Hz"
    whole = inertia + 1.5 * scale.inertia / turns**2
    frequency = 0.1 * (scale.stiffness / scale.inertia) ** 0.5 / (2.0 * pi) * float(rng.uniform(0.7, 1.3))
    proportional = 2.0 * pi * frequency * whole
    controller = {
        "kind": "speed_controller",
        "motor": name,
        "kp": Stated(proportional, "N*m*s/rad", 0.05),
        "ki": Stated(proportional * 2.0 * pi * frequency / 8.0, "N*m/rad", 0.05),
    }
    return {name: motor, "controller": controller, "motor_lines": _lines(rng, name, rated, (1, 2, pole_pairs))}


def _pole_pairs(scale: Scale) -> int:
    return round(3000.0 * RPM / scale.motor_speed)


def _supply(rng: np.random.Generator, name: str, scale: Scale, rated: float) -> dict[str, object]:
    slip = float(rng.uniform(0.03, 0.06))
    plate = 1.2 * rated
    return {
        "kind": "induction_drive",
        "motor": name,
        "pole_pairs": _pole_pairs(scale),
        "rated_torque": f"{plate:.6g} N*m",
        "rated_speed": f"{scale.motor_speed / RPM * (1.0 - slip):.6g} rpm",
        "breakdown_torque": Stated(plate * float(rng.uniform(2.2, 3.0)), "N*m", 0.05),
    }


def _lines(rng: np.random.Generator, name: str, rated: float, orders: tuple[int, ...]) -> dict[str, object]:
    sizes = {order: rated * float(10.0 ** rng.uniform(-2.6, -1.7)) for order in dict.fromkeys(orders)}
    amplitudes = {order: Stated(size, "N*m") for order, size in sizes.items()}
    return {"kind": "torque_ripple", "at": name, "group": "mechanical", "amplitudes": amplitudes,
            "amplitude_rel_sd": 0.25}  # fmt: skip
