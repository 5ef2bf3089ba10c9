"""Dry friction with a Stribeck peak at the last shaft."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnosis.fitting.knobs import Knob
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context

NAMES = ("stribeck_friction",)

_LOG_ODDS = -3.0
_COULOMB = 0.1  # of the largest mean torque: prior median
_STATIC = 2.0  # times the Coulomb torque: prior median of the peak
_SPEED = 0.05  # of the largest speed of the shaft: prior median of the Stribeck speed
_SPEED_SPREAD = 1.5  # of its logarithm
_STARTS = ((-0.5, -0.5, 0.0), (0.0, 0.0, 0.0), (0.5, 0.5, 0.0), (0.5, 0.5, -1.0), (0.0, 0.3, 1.0))


def propose(context: Context) -> Iterator[Addition]:
    """Yield friction at the last shaft."""
    shaft, name = context.shafts[-1], free_name(context.rig, "stribeck_friction")
    fastest, torque = context.fastest(shaft), _COULOMB * context.largest_level
    if fastest > 0 and torque > 0:
        part = mechanisms.StribeckFriction(
            name=name, at=shaft.part, coulomb=torque, static=_STATIC * torque, stribeck_speed=_SPEED * fastest
        )
        yield Addition(
            mechanism="stribeck_friction", parts=(part,), starts=_STARTS, log_odds=_LOG_ODDS,
            knobs=(Knob(name, "coulomb", DECADE), Knob(name, "static", DECADE),
                   Knob(name, "stribeck_speed", _SPEED_SPREAD)),
            label=f"dry friction at {shaft.part}",
            reported=(Reported("coulomb_Nm", "coulomb", "N*m"), Reported("static_Nm", "static", "N*m"),
                      Reported("stribeck_rad_s", "stribeck_speed", "rad/s")),
        )  # fmt: skip
