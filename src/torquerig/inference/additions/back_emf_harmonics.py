"""Back-EMF harmonics: a voltage that is no sine makes a torque of order 6p in proportion to the load."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.rig.parts import MotorPhases

NAMES = ("back_emf_harmonics",)

_LOG_ODDS = -3.0  # few motors have an exact sine
_HARMONIC = 7  # only the difference of the 7th and the 5th shows


def propose(context: Context) -> Iterator[Addition]:
    """Yield harmonics for each motor whose phases are stated as sines and that shows a line of order 6p."""
    name = free_name(context.rig, "back_emf_harmonics")
    for phases in context.rig.parts_of(MotorPhases):
        order = 6.0 * phases.pole_pairs
        lines = context.at_orders(1.0, (order,)) if phases.flat_angle is None else {}
        for place in lines.values():

            def wrong(share: float, at: str = phases.motor) -> mechanisms.BackEmfHarmonics:
                return mechanisms.BackEmfHarmonics(name=name, at=at, shares={_HARMONIC: share})

            yield from one_size(
                context, wrong, field="shares", key=_HARMONIC, place=place, unit=0.01,
                mechanism="commutation_ripple", variant="back_emf_harmonics", log_odds=_LOG_ODDS,
                label=f"harmonics in the back-EMF of {phases.motor}, order {order:g}",
                fixed={"order_motor": (order, 0.0, "1/rev")},
                reported=(Reported("seventh_less_fifth", "shares", "1", key=_HARMONIC),),
            )  # fmt: skip
