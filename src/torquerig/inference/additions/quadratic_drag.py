"""Quadratic drag: a load by the square of the speed."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob

NAMES = ("quadratic_drag",)

_LOG_ODDS = -3.0
_SHARE = 0.1  # of the largest mean torque, at the largest speed: prior median
_STARTS = ((-1.0,), (0.0,), (1.0,))


def propose(context: Context) -> Iterator[Addition]:
    """Yield drag at the last shaft."""
    shaft, name = context.shafts[-1], free_name(context.rig, "quadratic_drag")
    fastest = context.fastest(shaft)
    if fastest > 0 and context.largest_level > 0:
        coefficient = _SHARE * context.largest_level / fastest**2
        yield Addition(
            mechanism="quadratic_drag", knobs=(Knob(name, "coefficient", DECADE),), starts=_STARTS,
            parts=(mechanisms.QuadraticDrag(name=name, at=shaft.part, coefficient=coefficient),),
            log_odds=_LOG_ODDS, label=f"a drag at {shaft.part} by the square of the speed",
            reported=(Reported("coefficient_Nms2", "coefficient", "N*m*s^2/rad^2"),),
        )  # fmt: skip
