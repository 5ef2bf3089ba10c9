"""Commutation ripple: a share of the motor's torque at a whole order of the motor."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.rig.parts import Motor

NAMES = ("commutation_ripple",)

_OF_THE_FIELD, _WHOLE = -2.5, -7.0  # log-odds at p, 2p and multiples of 6p, and at any whole order
_MEDIAN = 0.03  # of the torque: prior median of the depth
_HARMONICS = 4


def propose(context: Context) -> Iterator[Addition]:
    """Yield a ripple for each found whole order of each motor, and for those of its field that no search finds.

    No search finds what sway spreads or what falls on another line of the rig.
    """
    for motor in context.rig.parts_of(Motor):
        for line in context.lines:
            order = context.whole(line.place)
            if order is not None:
                yield from _ripple(context, motor, order, context.multiples(line.place, most=_HARMONICS))
        pairs = motor.pole_pairs or 0
        of_field = [pairs, 2 * pairs, 6 * pairs] if pairs else []
        for own in context.smeared(of_field):
            yield from _ripple(context, motor, int(own), {1: None})
        for own, place in context.on_known_lines(of_field).items():
            yield from _ripple(context, motor, int(own), context.multiples(place, most=_HARMONICS))


def _ripple(context: Context, motor: Motor, order: int, multiples: Mapping[int, Place | None]) -> Iterator[Addition]:
    name = free_name(context.rig, "commutation_ripple")

    def ripple(first: float, depth: float, further: tuple[float, ...] = ()) -> mechanisms.CommutationRipple:
        return mechanisms.CommutationRipple(name=name, at=motor.name, order_motor=first, depth=depth, harmonics=further)

    found = harmonics(
        context, multiples, unit=lambda multiple: ripple(float(multiple * order), 1.0), median=_MEDIAN,
        knob=lambda multiple: Knob(name, "depth", DECADE) if multiple == 1
        else Knob(name, "harmonics", DECADE, key=multiple - 2),
    )  # fmt: skip
    if 1 not in found.medians:
        return
    pairs = motor.pole_pairs or 0
    of_field = bool(pairs) and (order in (pairs, 2 * pairs) or order % (6 * pairs) == 0)
    depth, *further = found.row()
    yield Addition(
        mechanism="commutation_ripple", parts=(ripple(float(order), depth, tuple(further)),),
        knobs=tuple(found.knobs), starts=(tuple(found.start),), places=tuple(filter(None, multiples.values())),
        log_odds=_OF_THE_FIELD if of_field else _WHOLE,
        label=f"a ripple of {motor.name} at order {order}, in proportion to its torque",
        fixed={"order_motor": (float(order), 0.0, "1/rev")}, reported=(Reported("depth", "depth", "1"),),
    )  # fmt: skip
