"""Dry friction with a Stribeck peak at the last shaft."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import log

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.inference.one_number import FAR
from torquerig.inference.shafts import Shaft

NAMES = ("stribeck_friction",)

_LOG_ODDS, _BY_DIRECTION = -3.0, -4.5
_COULOMB = 0.1  # of the largest mean torque: prior median
_STATIC = 2.0  # times the Coulomb torque: prior median of the peak
_SPEED = 0.05  # of the largest speed of the shaft: prior median of the Stribeck speed
_SPEED_SPREAD = 1.5  # of its logarithm
_STARTS = ((-0.5, -0.5, 0.0), (0.0, 0.0, 0.0), (0.5, 0.5, 0.0), (0.5, 0.5, -1.0), (0.0, 0.3, 1.0))
_INSTEAD = (
    (0.0, 0.0, 0.0),
    (0.0, 0.0, 0.5),
    (0.0, 0.2, 0.0),
    (0.0, -0.2, 0.5),
)  # where the Coulomb torque is known


def propose(context: Context) -> Iterator[Addition]:
    """Yield friction at the last shaft, and one by direction where the runs turn both ways."""
    shaft, name = context.shafts[-1], free_name(context.rig, "stribeck_friction")
    fastest, torque = context.fastest(shaft), _COULOMB * context.largest_level
    instead, moved = _moved_instead(context, shaft)
    at = log(instead / torque) / DECADE if instead and torque else 0.0
    starts = tuple((at + one, at + two, three) for one, two, three in (_INSTEAD if instead else _STARTS))
    if not fastest or not torque:
        return
    part = mechanisms.StribeckFriction(
        name=name, at=shaft.part, coulomb=torque, static=_STATIC * torque, stribeck_speed=_SPEED * fastest
    )
    sizes = Knob(name, "coulomb", DECADE), Knob(name, "static", DECADE)
    speed, of_speed = Knob(name, "stribeck_speed", _SPEED_SPREAD), Reported("stribeck_rad_s", "stribeck_speed", "rad/s")
    yield Addition(
        mechanism="stribeck_friction", parts=(part,), starts=starts, stated=moved, log_odds=_LOG_ODDS,
        knobs=(*sizes, speed),
        label=f"dry friction at {shaft.part}",
        reported=(Reported("coulomb_Nm", "coulomb", "N*m"), Reported("static_Nm", "static", "N*m"), of_speed),
    )  # fmt: skip
    if context.turns_both_ways:
        backward = Knob(name, "coulomb_backward", DECADE), Knob(name, "static_backward", DECADE)
        yield Addition(
            mechanism="stribeck_friction", variant="by_direction", knobs=(*sizes, speed, *backward),
            parts=(replace(part, coulomb_backward=part.coulomb, static_backward=part.static),),
            starts=tuple((*start, *start[:2]) for start in starts), stated=moved, log_odds=_BY_DIRECTION,
            label=f"dry friction at {shaft.part} that differs by direction",
            reported=(
                Reported("coulomb_Nm_forward", "coulomb", "N*m"), Reported("static_Nm_forward", "static", "N*m"),
                Reported("coulomb_Nm_backward", "coulomb_backward", "N*m"),
                Reported("static_Nm_backward", "static_backward", "N*m"), of_speed,
            ),
        )  # fmt: skip


def _moved_instead(context: Context, shaft: Shaft) -> tuple[float, frozenset[str]]:
    """Return by how much stated dry torques of a shaft have grown in place of another one [N m], and their names."""
    fit, node = context.fit, context.rig.node(shaft.part)
    stated = {part.name for part in fit.nominal.parts if context.rig.node(part.name) == node}
    moved = [
        knob for knob, position in zip(fit.knobs, fit.positions, strict=True)
        if knob.field == "coulomb" and knob.part in stated and position > FAR
    ]  # fmt: skip
    return sum(knob.value(context.rig) - knob.value(fit.rig) for knob in moved), frozenset(knob.name for knob in moved)
