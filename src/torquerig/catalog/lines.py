"""The torque lines that a drawn motor makes: at which order of its shaft, how large, and what the size follows."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import lcm

from torquerig.catalog.drawing import Drawn
from torquerig.catalog.motor import Motor
from torquerig.signals.kinematics import Family

KNOWN_FAMILIES: dict[str, Family] = {
    "mechanical": "motor",
    "cogging_as_published": "cogging_as_published",
    "electrical": "electrical",
}


@dataclass(frozen=True)
class RippleLine:
    """One sinusoidal torque on the motor's shaft.

    Parameters
    ----------
    family : Family
        Its cause, in the vocabulary of ``torquerig.signals.kinematics``.
    order : int
        Periods per turn of the motor [1/rev].
    torque : float
        Zero-to-peak torque whatever the load [N m], >= 0.
    share : float
        Zero-to-peak share of the transmitted torque [1], >= 0.
    """

    family: Family
    order: int
    torque: float = 0.0
    share: float = 0.0


def ripple_lines(motor: Drawn[Motor]) -> tuple[RippleLine, ...]:
    """Return the known lines of the motor, or, where there are none, the lines that its class has.

    Source: handbook 1.1 (native cogging), 1.2 (tolerance cogging), 1.4 and 1.5 (six pulses), 1.8 (cage), 2.1 (current
    offset), 2.2 (current gain). Only the fundamental of each class line is given; phases are not known. An induction
    motor's slip is left out: its electrical lines stand slightly above whole orders of the shaft.
    """
    known = motor.entry.ripple.known_lines
    lines = _class_lines(motor) if known is None else _known_lines(motor)
    return tuple(line for line in lines if line.torque or line.share)


def _known_lines(motor: Drawn[Motor]) -> Iterator[RippleLine]:
    for name, family in KNOWN_FAMILIES.items():
        for order in getattr(motor.entry.ripple.known_lines, name):
            yield RippleLine(family, order, torque=motor.value(f"ripple.known_lines.{name}.{order}"))


def _class_lines(motor: Drawn[Motor]) -> Iterator[RippleLine]:
    poles, slots = motor.count("pole_pairs"), round(motor.values.get("slots", 0))
    rated = motor.value("rated_torque")
    share = {key: motor.values.get(f"ripple.{key}", 0.0) for key in type(motor.entry.ripple).model_fields}
    yield RippleLine("motor", 1, torque=rated * share["mechanical_unbalance"])
    yield RippleLine("electrical", poles, torque=rated * share["current_offset_ripple"])
    yield RippleLine("electrical", 2 * poles, share=share["current_gain_ripple"])
    yield RippleLine("six_pulse", 6 * poles, share=share["six_pulse_ripple"])
    if slots:
        tolerance = rated * share["cogging_tolerance"]
        yield RippleLine("cogging", lcm(slots, 2 * poles), torque=rated * share["cogging_native"])
        yield RippleLine("cogging_tolerance_slots", slots, torque=tolerance)
        yield RippleLine("cogging_tolerance_poles", 2 * poles, torque=tolerance)
    if "rotor_bars" in motor.values:
        yield RippleLine("electrical", motor.count("rotor_bars"), share=share["rotor_slot_ripple"])
