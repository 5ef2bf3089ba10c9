"""Values of an entry that cannot hold together, each in one sentence with both values."""

from __future__ import annotations

from collections.abc import Iterator
from math import sqrt

from torquerig.catalog.checking.figures import HOT
from torquerig.catalog.entry import Entry
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.motor import Motor
from torquerig.parameter import Estimate

POWER_TOLERANCE = 0.05  # [1] power, torque and speed are printed with two or three digits each
HOTTEST_RISE = 155.0  # [K] class H (180 C, IEC 60085) in 25 C
COOLEST_RISE = 10.0  # [K] a motor that is rated at so little would be rated higher

Range = tuple[float, float]


def contradictions(entry: Entry) -> list[str]:
    """Return what contradicts in ``entry``; empty where nothing does. What is not stated contradicts nothing."""
    if isinstance(entry, Motor):
        found = [*_power(entry), *_heat(entry), *_voltage(entry), *_stall(entry)]
        return [one for one in found if one]
    return list(_gear_rating(entry)) if isinstance(entry, Gearbox) else []


def _range(value: Estimate) -> Range | None:
    return None if value.unknown else value.bounds


def _power(motor: Motor) -> Iterator[str]:
    power, torque, speed = (_range(one) for one in (motor.rated_power, motor.rated_torque, motor.rated_speed))
    if power is None or torque is None or speed is None:
        return
    low, high = torque[0] * speed[0], torque[1] * speed[1]
    if power[1] < low * (1 - POWER_TOLERANCE) or power[0] > high * (1 + POWER_TOLERANCE):
        yield (
            f"rated_power {motor.rated_power.shown()} is not rated_torque x rated_speed, which gives "
            f"{_ends(low, high)} W; check whether one of the three is a peak or S3 value"
        )


def _heat(motor: Motor) -> Iterator[str]:
    """Compare the copper loss at rated torque with what the thermal resistance allows."""
    parts = [_range(one) for one in (motor.rated_torque, motor.torque_constant, motor.phase_resistance,
                                     motor.thermal_resistance)]  # fmt: skip
    if motor.kind == "induction" or any(one is None for one in parts):
        return
    torque, constant, resistance, thermal = (one for one in parts if one is not None)
    phases = 2 if motor.kind == "bldc" else 3
    low = phases * resistance[0] * HOT * (torque[0] / constant[1]) ** 2 * thermal[0]
    high = phases * resistance[1] * HOT * (torque[1] / constant[0]) ** 2 * thermal[1]
    said = (
        f"rated_torque over torque_constant in phase_resistance heats the winding by {_ends(low, high)} K over ambient"
    )
    if low > HOTTEST_RISE:
        yield (
            f"{said}, more than {HOTTEST_RISE:.0f} K of class H; check whether the resistance is line-to-line (halve "
            "it), the torque constant per peak ampere, or the torque an S3 value"
        )
    elif high < COOLEST_RISE:
        yield (
            f"{said}, so the motor could give much more than its rating; check the resistance (per phase or "
            "line-to-line) and the thermal resistance (on which flange)"
        )


def _voltage(motor: Motor) -> Iterator[str]:
    speed, constant, supply = (_range(one) for one in (motor.max_speed, motor.torque_constant, motor.supply_voltage))
    if motor.kind == "induction" or speed is None or constant is None or supply is None:
        return
    # a six-step motor needs a DC link of sqrt(2) times the supply's rms to exceed its line-to-line peak
    least = speed[0] * constant[0] / (sqrt(2) if motor.kind == "bldc" else sqrt(3))
    if least > supply[1]:
        yield (
            f"torque_constant {motor.torque_constant.shown()} makes {least:.0f} V at max_speed "
            f"{motor.max_speed.shown()}, more than the supply of {motor.supply_voltage.shown()}; check peak "
            "against rms, or the winding's voltage"
        )


def _stall(motor: Motor) -> Iterator[str]:
    stall, rated = _range(motor.stall_torque), _range(motor.rated_torque)
    if stall is not None and rated is not None and stall[1] < rated[0] * (1 - POWER_TOLERANCE):
        yield (
            f"stall_torque {motor.stall_torque.shown()} is below rated_torque {motor.rated_torque.shown()}; exchange "
            "them, or check whether one is for S3"
        )


def _gear_rating(box: Gearbox) -> Iterator[str]:
    nominal, peak = _range(box.nominal_torque), _range(box.peak_torque)
    if nominal is not None and peak is not None and peak[1] < nominal[0]:
        shown = box.nominal_torque.shown()
        yield f"peak_torque {box.peak_torque.shown()} is below nominal_torque {shown}; exchange them"


def _ends(low: float, high: float) -> str:
    return f"{low:.4g}" if f"{low:.4g}" == f"{high:.4g}" else f"{low:.3g}..{high:.3g}"
