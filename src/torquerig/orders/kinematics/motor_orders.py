"""The orders of a motor's lines on its own shaft, from poles and slots, and what is missing where one is unknown."""

from __future__ import annotations

from math import lcm
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.orders.kinematics.line_families import Family

# families that are orders of a torque; the others of a motor's counts are in tables because reports name them
TORQUE_FAMILIES: tuple[Family, ...] = (
    "cogging", "cogging_tolerance_slots", "cogging_tolerance_poles", "electrical", "six_pulse",
)  # fmt: skip


def motor_orders(pole_pairs: int | None, slots: int | None) -> dict[Family, int]:
    """Return the fundamental of each family that the known counts determine, in periods per turn of the motor [1/rev].

    Source: handbook 1.1, 1.2, 1.4, 2.1 to 2.3. Slip of an induction machine is not included.
    """
    p = pole_pairs
    orders: dict[Family, int | None] = {
        "cogging_per_pole": lcm(slots, 2 * p) // (2 * p) if p and slots else None,
        "cogging": lcm(slots, 2 * p) if p and slots else None,
        "cogging_tolerance_slots": slots,
        "cogging_tolerance_poles": 2 * p if p else None,
        "electrical": p,
        "six_pulse": 6 * p if p else None,
    }
    return {family: order for family, order in orders.items() if order is not None}


def missing_counts(pole_pairs: int | None, slots: int | None) -> dict[Family, str]:
    """Return the families that unknown counts leave out, each with the count: ``pole pairs`` or ``slots``."""
    missing: dict[Family, str] = {}
    if pole_pairs is None:
        missing |= dict.fromkeys(("cogging_tolerance_poles", "electrical", "six_pulse"), "pole pairs")
    if slots is None:
        missing["cogging_tolerance_slots"] = "slots"
    if pole_pairs is None or slots is None:
        count = "slots" if slots is None else "pole pairs"
        missing |= dict.fromkeys(("cogging_per_pole", "cogging", "slots_times_pole_pairs"), count)
    return missing
