"""Encoder error: an angle that is read wrong once or twice a turn, which the speed loop answers to."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.rig.parts import Motor, SpeedController

NAMES = ("encoder_error",)

_LOG_ODDS = -5.5  # of one of the orders
_ORDERS = (1, 2)  # a magnet or disc off the centre, and an oval one


def propose(context: Context) -> Iterator[Addition]:
    """Yield an error of each motor's encoder, where a speed loop reads it, at once and twice a turn."""
    name = free_name(context.rig, "encoder_error")
    controlled = {each.motor for each in context.rig.parts_of(SpeedController)}
    for motor in context.rig.parts_of(Motor):
        # the linear model takes the answer of the speed loop at the set-point
        known = motor.name in controlled and all(seen.run.is_steady for seen in context.data.seen)
        lines = context.at_orders(1.0, map(float, _ORDERS)) if known else {}
        for order, place in lines.items():

            def wrong(size: float, at: str = motor.name, order: int = round(order)) -> mechanisms.EncoderError:
                return mechanisms.EncoderError(name=name, at=at, amplitudes={order: size})

            yield from one_size(
                context, wrong, field="amplitudes", key=round(order), place=place, unit=1e-3,
                mechanism="encoder_error", log_odds=_LOG_ODDS,
                label=f"an error of the encoder of {motor.name} at order {order:g}",
                fixed={"order_motor": (order, 0.0, "1/rev")},
                reported=(Reported("angle_error_rad", "amplitudes", "rad", key=round(order)),),
            )  # fmt: skip
