"""The quantities that a channel can measure, and the kinds of unit that each may have."""

from __future__ import annotations

OTHER = "other"
"""A channel whose quantity is not known: kept and shown, never compared."""

KINDS: dict[str, tuple[str, ...]] = {
    "torque": ("torque",),
    "force": ("force",),
    "motor_torque": ("torque",),
    "current": ("current",),
    "voltage": ("voltage",),
    "motor_angle": ("angle",),
    "angle": ("angle",),
    "position": ("length",),
    "motor_speed": ("speed",),
    "speed": ("speed",),
    "velocity": ("linear speed",),
    "temperature": ("temperature", "temperature difference"),
    "tacho": ("share",),
    "acceleration": ("acceleration", "angular acceleration"),
    "pressure": ("pressure",),
    "power": ("power",),
    "time": ("time",),
    OTHER: (),
}
"""Kinds of unit (of ``units.UNITS``) of each quantity; a tacho's reading is a bare number."""

QUANTITIES = tuple(KINDS)

ROLES = ("compared", "input", "context")
"""What a channel is for: compared with the model, an input of the model, or shown only."""
