"""The smallest and largest sensible size of each kind of quantity [SI], beyond which a number is a slip."""

from __future__ import annotations

from collections.abc import Mapping

LIMITS: Mapping[str, tuple[float, float]] = {
    "torque": (1e-15, 1e9),
    "inertia": (1e-11, 1e9),  # a rotor of 1 mm has 1e-11, a turbine of a power station 1e5
    "speed": (1e-12, 1e6),  # the fastest spindles turn at 5e4 rad/s
    "frequency": (1e-9, 1e9),
    "angle": (1e-15, 1e9),
    "torsional stiffness": (1e-9, 1e12),  # a solid steel shaft 1 m thick and 1 m long has 8e9
    "rotary damping": (1e-15, 1e9),
    "quadratic drag": (1e-18, 1e9),
    "time": (1e-12, 1e9),  # 30 years
    "rate": (1e-9, 1e9),
    "order": (1e-9, 1e6),
    "length": (1e-12, 1e6),
    "mass": (1e-9, 1e9),
    "force": (1e-15, 1e12),
    "linear stiffness": (1e-9, 1e13),
    "linear damping": (1e-15, 1e12),
    "linear quadratic drag": (1e-18, 1e12),
    "linear speed": (1e-15, 1e5),
    "voltage": (1e-15, 1e8),
    "current": (1e-15, 1e7),
    "rms current": (1e-15, 1e7),
    "torque constant (per rms ampere)": (1e-9, 1e5),
    "torque constant": (1e-9, 1e5),
    "resistance": (1e-9, 1e12),
    "inductance": (1e-12, 1e5),
    "flux linkage": (1e-12, 1e5),
    "power": (1e-15, 1e11),
    "energy": (1e-15, 1e15),
    "thermal resistance": (1e-6, 1e6),
    "temperature difference": (1e-9, 1e5),
    "sensitivity": (1e-12, 1e9),
    "force sensitivity": (1e-12, 1e9),
    "price": (1e-6, 1e12),
    "data": (1.0, 64.0),
    "share": (1e-18, 1e9),
}
"""By kind of quantity: both ends are at least a hundred times beyond real machines, but the length of a converter."""


def beyond_sense(number: float, kind: str) -> float | None:
    """Return the nearest sensible size [SI] where the size of ``number`` is beyond reason, else None; 0 is sensible."""
    smallest, largest = LIMITS.get(kind, (0.0, 1e30))
    size = abs(number)
    if size > largest:
        return largest
    return smallest if 0 < size < smallest else None
