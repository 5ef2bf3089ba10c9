"""Cogging: a torque between magnets and teeth at multiples of slots and poles, whatever the load."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.rig.parts import Motor

NAMES = ("cogging",)

_LOG_ODDS = -2.5


def propose(context: Context) -> Iterator[Addition]:
    """Yield one cogging with all found lines at orders of slots or poles, and one with each of the two families."""
    for motor in context.rig.parts_of(Motor):
        if not motor.slots or not motor.pole_pairs or context.rig.of_kind("cogging"):
            continue
        base = mechanisms.Cogging(
            name=free_name(context.rig, "cogging"), at=motor.name, slots=motor.slots, pole_pairs=motor.pole_pairs
        )
        found: dict[int, Place | None] = {int(order): None for order in context.smeared(base.fixed_orders().values())}
        for line in context.lines:
            order = context.whole(line.place)
            if order is not None:
                found[order] = line.place
        by_slots = {order: place for order, place in found.items() if order % motor.slots == 0}
        by_poles = {order: place for order, place in found.items() if order % (2 * motor.pole_pairs) == 0}
        families = [by_slots | by_poles, by_slots, by_poles]
        for index, family in enumerate(families):
            if family and family not in families[:index]:
                yield from _cogging(context, base, family)


def _cogging(context: Context, base: mechanisms.Cogging, orders: dict[int, Place | None]) -> Iterator[Addition]:
    name = base.name
    held = {order: base.held_by(order) for order in orders}
    found = harmonics(
        context, orders, unit=lambda order: base.with_amplitudes({order: 1.0}),
        knob=lambda order: Knob(name, held[order][0], DECADE, key=held[order][1]),
    )  # fmt: skip
    if found.medians:
        largest = max(found.medians, key=lambda order: found.start[[*found.medians].index(order)])
        yield Addition(
            mechanism="cogging", parts=(base.with_amplitudes(found.medians),), knobs=tuple(found.knobs),
            starts=(tuple(found.start),), places=tuple(filter(None, orders.values())), log_odds=_LOG_ODDS,
            label=f"cogging of {base.at}", fixed={"order_motor": (float(largest), 0.0, "1/rev")},
            reported=(Reported("amplitude_Nm", held[largest][0], "N*m", key=held[largest][1]),),
        )  # fmt: skip
