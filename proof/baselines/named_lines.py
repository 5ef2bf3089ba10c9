"""The kinematic table of spectral lines, with mechanism names of the contract."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import pi

from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of

FAMILIES = {
    "cogging": "cogging",
    "cogging_tolerance_slots": "cogging",
    "cogging_tolerance_poles": "cogging",
    "cogging_per_pole": "cogging",
    "electrical": "commutation_ripple",
    "six_pulse": "commutation_ripple",
    "gear_mesh": "gear_mesh",
}
"""Mechanisms of the contract for families of the kinematic table."""
MAINS = (50.0, 60.0)  # [Hz]
HARMONICS = 6
BLADES = range(2, 13)  # output orders assigned to blades; higher orders are assigned to teeth
TEETH = range(13, 131)
PRIORITY = ("mains_interference", "cogging", "commutation_ripple", "gear_mesh", "blade_pass")


@dataclass(frozen=True)
class NamedLine:
    """One row: mechanism, identifying parameter and value, and frequency at this speed [Hz]."""

    mechanism: str
    parameter: str
    value: float
    frequency: float


def named_lines(rig: Rig, *, motor_speed: float) -> tuple[NamedLine, ...]:
    """Return all rows at a speed [rad/s]; at equal frequencies ``PRIORITY`` gives the order."""
    rows = [*_mains(), *_of_table(rig, motor_speed), *_of_output(rig, motor_speed)]
    rows.sort(key=lambda row: PRIORITY.index(row.mechanism))
    return tuple(rows)


def _mains() -> Iterator[NamedLine]:
    for grid in MAINS:
        for harmonic in range(1, HARMONICS + 1):
            yield NamedLine("mains_interference", "frequency_Hz", grid, grid * harmonic)


def _of_table(rig: Rig, speed: float) -> Iterator[NamedLine]:
    kinematics = kinematics_of(rig)
    for line in kinematics.lines(HARMONICS):
        name = FAMILIES.get(line.family)
        if name is not None:
            first = line.motor_order / line.harmonic
            of_output = name == "gear_mesh"
            value = first * kinematics.ratio if of_output else first
            yield NamedLine(name, "order_output" if of_output else "order_motor", value,
                            line.motor_order * abs(speed) / (2 * pi))  # fmt: skip


def _of_output(rig: Rig, speed: float) -> Iterator[NamedLine]:
    """Yield whole orders of the output shaft: blades, and teeth of unknown number."""
    turns = abs(speed) / (2 * pi) / kinematics_of(rig).ratio
    for order in (*BLADES, *TEETH):
        name = "blade_pass" if order in BLADES else "gear_mesh"
        yield NamedLine(name, "order_output", float(order), order * turns)
