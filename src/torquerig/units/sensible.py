"""The smallest and largest sensible size of each kind of quantity [SI], beyond which a number is a slip."""

from __future__ import annotations

from collections.abc import Mapping

LIMITS: Mapping[str, tuple[float, float]] = {
    "torque": (0.0, 1e9),
    "inertia": (1e-11, 1e9),  # a rotor of 1 mm has 1e-11, a turbine of a power station 1e5
    "speed": (0.0, 1e6),  # the fastest spindles turn at 5e4 rad/s
    "angular acceleration": (0.0, 1e12),
    "frequency": (1e-9, 1e9),
    "angle": (0.0, 1e9),
    "torsional stiffness": (1e-9, 1e12),  # a solid steel shaft 1 m thick and 1 m long has 8e9
    "rotary damping": (0.0, 1e9),
    "quadratic drag": (0.0, 1e9),
    "time": (1e-12, 1e9),  # 30 years
    "rate": (0.0, 1e9),
    "order": (1e-9, 1e6),
    "length": (1e-12, 1e6),
    "mass": (1e-9, 1e9),
    "force": (0.0, 1e12),
    "linear stiffness": (1e-9, 1e13),
    "linear damping": (0.0, 1e12),
    "linear quadratic drag": (0.0, 1e12),
    "linear speed": (0.0, 1e5),
    "voltage": (0.0, 1e8),
    "current": (0.0, 1e7),
    "rms current": (0.0, 1e7),
    "torque constant (per rms ampere)": (1e-9, 1e5),
    "torque constant": (1e-9, 1e5),
    "resistance": (1e-9, 1e12),
    "inductance": (1e-12, 1e5),
    "flux linkage": (0.0, 1e5),
    "power": (0.0, 1e11),
    "energy": (0.0, 1e15),
    "thermal resistance": (1e-6, 1e6),
    "temperature difference": (0.0, 1e5),
    "sensitivity": (0.0, 1e9),
    "force sensitivity": (0.0, 1e9),
    "price": (0.0, 1e12),
    "data": (1.0, 64.0),
    "share": (0.0, 1e9),
}
"""By kind of quantity: both ends are at least a hundred times beyond real machines, but the length of a converter.

The smallest is 0 where a small number does no harm: a fit may find any small torque or friction.
"""


def beyond_sense(number: float, kind: str) -> float | None:
    """Return the nearest sensible size [SI] where the size of ``number`` is beyond reason, else None; 0 is sensible."""
    smallest, largest = LIMITS.get(kind, (0.0, 1e30))
    size = abs(number)
    if size > largest:
        return largest
    return smallest if 0 < size < smallest else None
