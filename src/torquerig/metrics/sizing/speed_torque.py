"""Continuous and intermittent torque of a motor over speed, each with the interval of the open catalog values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from torquerig.catalog.motor import Motor
from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.open_data import Values, over_intervals
from torquerig.metrics.sizing.required_torque import mean_speed
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.parameter import Estimate
from torquerig.scenario.drive_requirement import DriveRequirement

Floats = NDArray[np.float64]
POINTS = 240


@dataclass(frozen=True, kw_only=True)
class SpeedTorque:
    """Limits over speed, all of shape (points,), zero above the largest speed.

    Parameters
    ----------
    speed : ndarray
        [rad/s]
    continuous, intermittent : ndarray, shape (points, 2)
        Lowest and highest torque that the data allow [N m].
    drive_limit : float
        The drive's torque limit as set [N m].
    missing : tuple of str
        The values that are not known exactly.
    """

    speed: Floats
    continuous: Floats
    intermittent: Floats
    drive_limit: float
    missing: tuple[str, ...]


def speed_torque(drive: SizedDrive) -> SpeedTorque:
    """Return both regions of a motor.

    Continuous: linear from the stall torque to the rated torque at rated speed, above it at rated power. Intermittent:
    the peak torque, limited by the voltage of an ideal inverter where supply, torque constant, resistance and
    inductance are known. Otherwise between peak torque up to the largest speed, and peak torque up to the rated speed
    with constant power above. Hot magnets and saturation of the iron are not included.
    """
    motor = drive.motor
    speed = np.linspace(0.0, motor.max_speed.bounds[1], POINTS)
    stall = motor.rated_torque if motor.stall_torque.unknown else motor.stall_torque
    ends = [one.bounds for one in (stall, motor.rated_torque, motor.rated_speed, motor.max_speed)]
    continuous = np.array([continuous_torque(speed, *corner) for corner in product(*ends)])
    named = {"stall torque": motor.stall_torque, "rated torque": motor.rated_torque, "rated speed": motor.rated_speed,
             "maximum speed": motor.max_speed, "peak torque": motor.peak_torque}  # fmt: skip
    missing = [name for name, one in named.items() if not one.documented and one.bounds[0] < one.bounds[1]]
    voltage = voltage_data(motor)
    missing += [name for name, one in voltage.items() if one.unknown]
    return SpeedTorque(
        speed=speed,
        continuous=np.stack([continuous.min(axis=0), continuous.max(axis=0)], axis=1),
        intermittent=_intermittent(motor, speed),
        drive_limit=drive.part.torque_limit,
        missing=tuple(f"{name} of {drive.motor_name}" for name in missing),
    )


def region_use(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``continuous_use``, ``intermittent_use`` and ``speed_limit_use`` [1].

    The rms torque over the continuous torque at the mean speed; the largest torque of any moment over the intermittent
    torque at its speed; the top speed over the largest.
    """
    name, motor = drive.motor_name, drive.motor
    stall = motor.rated_torque if motor.stall_torque.unknown else motor.stall_torque
    top = f"maximum speed of {name}"
    first = "rated torque" if motor.stall_torque.unknown else "stall torque"
    keys = [f"{field} of {name}" for field in (first, "rated torque", "rated speed")]
    data = {**drive.data, **dict(zip(keys, (stall, motor.rated_torque, motor.rated_speed), strict=True))}

    def continuous(values: Values) -> float:
        requirement = drive.requirement(values)
        at = np.array([mean_speed(requirement)])
        still, rated, knee = (values[key] for key in keys)
        return requirement.rms_torque / float(continuous_torque(at, still, rated, knee, np.inf)[0])

    return {
        "continuous_use": over_intervals(data, continuous, source="rms torque / continuous torque at the mean speed"),
        "intermittent_use": _intermittent_use(drive),
        "speed_limit_use": over_intervals(
            {top: motor.max_speed}, lambda v: drive.requirement().top_speed / v[top], source="top speed / maximum speed"
        ),
    }


def continuous_torque(speed: Floats, stall: float, rated: float, rated_speed: float, top: float) -> Floats:
    """Return the continuous torque at ``speed`` [rad/s], in [N m]."""
    below = stall + (rated - stall) * np.minimum(speed / rated_speed, 1.0)
    held = np.where(speed > rated_speed, rated * rated_speed / np.maximum(speed, rated_speed), below)
    return np.asarray(np.where(speed <= top * (1 + 1e-9), held, 0.0))


def voltage_torque(speed: Floats, *, supply: float, constant: float, resistance: float, reactance: float) -> Floats:
    """Return the torque [N m] at which the voltage between two phases reaches the supply's [V rms].

    ``(E + sqrt(3) R I)^2 + (sqrt(3) p w L I)^2 = V^2`` with ``E = Kt w / sqrt(3)``, solved for I; the current is in
    phase with the back-EMF (no field weakening). ``reactance`` is p L [H].
    """
    emf, across = constant * speed / sqrt(3), sqrt(3) * reactance * speed
    a, b, c = 3 * resistance**2 + across**2, 2 * sqrt(3) * resistance * emf, emf**2 - supply**2
    root = np.sqrt(np.maximum(0.0, b**2 - 4 * a * c))
    return np.asarray(np.where(c < 0, constant * (root - b) / (2 * a), 0.0))


def voltage_data(motor: Motor) -> dict[str, Estimate]:
    """Return the values that the voltage limit depends on, by name."""
    return {"supply voltage": motor.supply_voltage, "torque constant": motor.torque_constant,
            "phase resistance": motor.phase_resistance, "phase inductance": motor.phase_inductance}  # fmt: skip


def _intermittent(motor: Motor, speed: Floats) -> Floats:
    """Return lowest and highest intermittent torque, shape (points, 2)."""
    low, high = motor.peak_torque.bounds
    top = [np.where(speed <= end * (1 + 1e-9), 1.0, 0.0) for end in motor.max_speed.bounds]
    volts = _voltage_span(motor, speed)
    if volts is not None:
        return np.stack([np.minimum(low, volts[0]) * top[0], np.minimum(high, volts[1]) * top[1]], axis=1)
    knee = motor.rated_speed.bounds[0]
    falling = np.minimum(1.0, knee / np.maximum(speed, 1e-9))
    return np.stack([low * falling * top[0], high * top[1]], axis=1)


def _voltage_span(motor: Motor, speed: Floats) -> tuple[Floats, Floats] | None:
    parts = (motor.supply_voltage, motor.torque_constant, motor.phase_resistance, motor.phase_inductance)
    if any(one.unknown for one in parts):
        return None
    found = [
        voltage_torque(speed, supply=v, constant=k, resistance=r, reactance=p * ell)
        for v, k, r, ell, p in product(*(one.bounds for one in (*parts, motor.pole_pairs)))
    ]
    return np.min(found, axis=0), np.max(found, axis=0)


def _intermittent_use(drive: SizedDrive) -> Figure:
    """Return the largest share over all ends of pieces, from the smallest and the largest region."""
    name, peak = drive.motor_name, f"peak torque of {drive.motor_name}"

    def share(requirement: DriveRequirement, side: int) -> float:
        allowed = _intermittent(drive.motor, np.abs(requirement.speed).ravel())[:, side]
        torque = np.abs(requirement.torque).ravel()
        return float(np.max(np.where(torque > 0, torque / np.maximum(allowed, 1e-3 * torque), 0.0)))

    low = over_intervals(drive.data, lambda v: share(drive.requirement(v), 1))
    high = over_intervals(drive.data, lambda v: share(drive.requirement(v), 0))
    ends = [one.value if bound is None else bound for one, bound in ((low, low.low), (high, high.high))]
    source = "torque / intermittent torque at its speed, the largest share"
    curve = {peak: drive.motor.peak_torque, f"maximum speed of {name}": drive.motor.max_speed,
             f"rated speed of {name}": drive.motor.rated_speed}  # fmt: skip
    volts = {f"{key} of {name}": one for key, one in voltage_data(drive.motor).items()}
    rests_on = (*high.rests_on, *((key, one) for key, one in {**curve, **volts}.items() if one.source))
    if None in ends or ends[0] == ends[1]:
        return Figure(value=ends[0], source=source, rests_on=rests_on)
    open_facts = [] if drive.motor.peak_torque.documented else [peak]
    unknown = [key for key, one in voltage_data(drive.motor).items() if one.unknown]
    above = drive.requirement().top_speed > drive.motor.rated_speed.bounds[0]
    open_facts += [f"{key} of {name}" for key in unknown] if above else []
    missing = ", ".join([*open_facts, *([high.missing] if high.missing else [])])
    return Figure(low=ends[0], high=ends[1], source=source, missing=missing, rests_on=rests_on)
