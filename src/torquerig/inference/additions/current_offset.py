"""Current offset: an offset of the drive's current sensors, a torque at the order of the pole pairs at any load."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.rig.parts import Motor

NAMES = ("current_offset",)

_LOG_ODDS = -4.5  # the most common error of a drive with two current sensors
_CONSTANT = 1.0  # [N m/A] only offset times torque constant shows


def propose(context: Context) -> Iterator[Addition]:
    """Yield an offset for each motor with a line at the order of its pole pairs."""
    name = free_name(context.rig, "current_offset")
    for motor in context.rig.parts_of(Motor):
        pairs = motor.pole_pairs or 0
        for place in context.at_orders(1.0, (float(pairs),)).values() if pairs > 1 else ():

            def off(offset: float, at: str = motor.name, pairs: int = pairs) -> mechanisms.CurrentOffset:
                return mechanisms.CurrentOffset(
                    name=name, at=at, pole_pairs=pairs, torque_constant=_CONSTANT, offset_a=offset
                )

            yield from one_size(
                context, off, field="offset_a", place=place, mechanism="current_offset", log_odds=_LOG_ODDS,
                label=f"an offset of the current sensors of {motor.name}, order {pairs}",
                fixed={"order_motor": (float(pairs), 0.0, "1/rev")},
                reported=(Reported("offset_times_constant_Nm", "offset_a", "N*m"),),
            )  # fmt: skip
