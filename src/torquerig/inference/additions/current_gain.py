"""Current gain: current sensors of unequal gain make a torque of order 2p in proportion to the load."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.rig.parts import Motor

NAMES = ("current_gain",)

_LOG_ODDS = -3.0  # less than the class alone at this order, whose depth is what shows


def propose(context: Context) -> Iterator[Addition]:
    """Yield unequal gains for each motor that shows a line at twice its pole pairs."""
    name = free_name(context.rig, "current_gain")
    for motor in context.rig.parts_of(Motor):
        pairs = motor.pole_pairs or 0
        for place in context.at_orders(1.0, (2.0 * pairs,)).values() if pairs else ():

            def unequal(mismatch: float, at: str = motor.name, pairs: int = pairs) -> mechanisms.CurrentGain:
                return mechanisms.CurrentGain(name=name, at=at, pole_pairs=pairs, mismatch=mismatch)

            yield from one_size(
                context, unequal, field="mismatch", place=place, unit=0.01, mechanism="commutation_ripple",
                variant="current_gain", log_odds=_LOG_ODDS,
                label=f"unequal gains of the current sensors of {motor.name}, order {2 * pairs}",
                fixed={"order_motor": (2.0 * pairs, 0.0, "1/rev")},
                reported=(Reported("mismatch", "mismatch", "1"),),
            )  # fmt: skip
