"""Torque lines of a sampled motor: order of its shaft, amplitude, and dependence on load."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import lcm

from torquerig.catalog.motor import Motor
from torquerig.catalog.sampling import Sample
from torquerig.orders.kinematics.line_families import Family

KNOWN_FAMILIES: dict[str, Family] = {
    "mechanical": "motor",
    "cogging_per_pole": "cogging_per_pole",
    "electrical": "electrical",
}


@dataclass(frozen=True)
class RippleLine:
    """One sinusoidal torque on the motor's shaft.

    Parameters
    ----------
    family : Family
        Its cause, in the vocabulary of ``torquerig.orders.kinematics.line_families``.
    order : int
        Periods per turn of the motor [1/rev].
    torque : float
        Zero-to-peak torque, independent of the load [N m], >= 0.
    share : float
        Zero-to-peak share of the transmitted torque [1], >= 0.
    field : str
        Field of the catalog entry with its amplitude: ``ripple.cogging_native``.
    """

    family: Family
    order: int
    torque: float = 0.0
    share: float = 0.0
    field: str = ""


def ripple_lines(motor: Sample[Motor]) -> tuple[RippleLine, ...]:
    """Return the known lines of the motor, or the lines of its class where none are known.

    Source: handbook 1.1 (native cogging), 1.2 (tolerance cogging), 1.4 and 1.5 (six pulses), 1.8 (cage), 2.1 (current
    offset), 2.2 (current gain). Only the fundamental of each class line is given; phases are not known. The slip
    of an induction motor is not included: its electrical lines are slightly above integer orders of the shaft.
    """
    known = motor.entry.ripple.known_lines
    lines = _class_lines(motor) if known is None else _known_lines(motor)
    return tuple(line for line in lines if line.torque or line.share)


def _known_lines(motor: Sample[Motor]) -> Iterator[RippleLine]:
    for name, family in KNOWN_FAMILIES.items():
        for order in getattr(motor.entry.ripple.known_lines, name):
            field = f"ripple.known_lines.{name}.{order}"
            yield RippleLine(family, order, torque=motor.value(field), field=field)


def _class_lines(motor: Sample[Motor]) -> Iterator[RippleLine]:
    poles, slots = motor.count("pole_pairs"), round(motor.values.get("slots", 0))
    rated = motor.value("rated_torque")

    def line(family: Family, order: int, key: str, *, follows_load: bool = False) -> RippleLine:
        share = motor.values.get(f"ripple.{key}", 0.0)
        sizes = {"share": share} if follows_load else {"torque": rated * share}
        return RippleLine(family, order, field=f"ripple.{key}", **sizes)

    yield line("motor", 1, "mechanical_unbalance")
    yield line("electrical", poles, "current_offset_ripple")
    yield line("electrical", 2 * poles, "current_gain_ripple", follows_load=True)
    yield line("six_pulse", 6 * poles, "six_pulse_ripple", follows_load=True)
    if slots:
        yield line("cogging", lcm(slots, 2 * poles), "cogging_native")
        yield line("cogging_tolerance_slots", slots, "cogging_tolerance")
        yield line("cogging_tolerance_poles", 2 * poles, "cogging_tolerance")
    if "rotor_bars" in motor.values:
        yield line("electrical", motor.count("rotor_bars"), "rotor_slot_ripple", follows_load=True)
