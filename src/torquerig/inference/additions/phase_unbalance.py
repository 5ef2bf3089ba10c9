"""Phase unbalance: one phase of the motor with more resistance makes a torque of order 2p in proportion to the load."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.rig.parts import MotorPhases

NAMES = ("phase_unbalance",)

_LOG_ODDS = -4.0


def propose(context: Context) -> Iterator[Addition]:
    """Yield a bad contact in one phase for each motor whose phases are stated and that shows a line of order 2p."""
    name = free_name(context.rig, "phase_unbalance")
    for phases in context.rig.parts_of(MotorPhases):
        order = 2.0 * phases.pole_pairs
        for place in context.at_orders(1.0, (order,)).values():

            def unequal(ohms: float, at: str = phases.motor) -> mechanisms.PhaseUnbalance:
                return mechanisms.PhaseUnbalance(name=name, at=at, extra_resistance=(ohms, 0.0, 0.0))

            yield from one_size(
                context, unequal, field="extra_resistance", key=0, place=place, unit=0.1 * phases.phase_resistance,
                mechanism="commutation_ripple", variant="phase_unbalance", log_odds=_LOG_ODDS,
                label=f"more resistance in one phase of {phases.motor}, order {order:g}",
                fixed={"order_motor": (order, 0.0, "1/rev")},
                reported=(Reported("extra_resistance_ohm", "extra_resistance", "ohm", key=0),),
            )  # fmt: skip
