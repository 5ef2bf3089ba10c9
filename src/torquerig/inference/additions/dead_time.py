"""Dead time: the inverter's pauses make a torque of order 6p that does not grow with the load."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.rig.parts import MotorPhases

NAMES = ("dead_time",)

_LOG_ODDS = -3.0  # every inverter has one; how much of it is compensated is rarely stated
_UNIT = 1e-6  # [s]


def propose(context: Context) -> Iterator[Addition]:
    """Yield a dead time for each motor whose phases are stated and that shows a line six times per electrical turn."""
    name = free_name(context.rig, "dead_time")
    for phases in context.rig.parts_of(MotorPhases):
        order = 6.0 * phases.pole_pairs
        lines = context.at_orders(1.0, (order, 2 * order, 3 * order))
        if order in lines and phases.flat_angle is None:

            def late(time: float, at: str = phases.motor) -> mechanisms.DeadTime:
                return mechanisms.DeadTime(name=name, at=at, dead_time=time)

            yield from one_size(
                context, late, field="dead_time", place=lines[order], places=lines.values(), unit=_UNIT,
                mechanism="commutation_ripple", variant="dead_time", log_odds=_LOG_ODDS,
                label=f"a dead time of the inverter of {phases.motor}, order {order:g}",
                fixed={"order_motor": (order, 0.0, "1/rev")}, reported=(Reported("dead_time_s", "dead_time", "s"),),
            )  # fmt: skip
