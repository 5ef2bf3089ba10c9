"""Gear mesh: a kinematic error of a gear at a whole order of its output shaft."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import prod

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import SAME_MULTIPLE, Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.linear_twin.twin import Twin
from torquerig.orders.kinematics.belt import Belt
from torquerig.orders.kinematics.teeth import Planetary, Spur
from torquerig.orders.kinematics.worm import Worm
from torquerig.rig.parts.gear_stage import gear_stages

NAMES = ("gear_mesh",)

_STATED, _WHOLE = -3.0, -6.5  # log-odds at the stated number of teeth, and at a whole one where none is stated
_FEWEST = 8  # teeth of a wheel
_HARMONICS = 4
_SIDES = (1, 2, 3, 4, 5)  # times a turn that a mesh may be stronger: a wheel off its centre, an oval one, planets
_MODULATION, _MODULATION_SPREAD = 0.2, 1.0  # prior median, and of its logarithm


def propose(context: Context) -> Iterator[Addition]:
    """Yield a transmission error of each gear for each found order of its teeth, or whole one where it states none."""
    turns = Twin(context.rig).turns
    for gear in gear_stages(context.rig):
        own = turns.get(context.rig.node(gear.name), 0.0)
        if not own or gear.kind == "belt":
            continue
        if gear.teeth:
            orders = _stated_orders(gear.teeth)
            smeared = {order: None for order in orders if context.smeared([order * own])}
            for order, place in {**smeared, **context.at_orders(own, orders)}.items():
                yield from _mesh(context, gear.name, own, order, place, log_odds=_STATED)
            continue
        has_one = any(mesh.gear == gear.name for mesh in context.rig.parts_of(mechanisms.GearMesh))
        for line in () if has_one else context.lines:  # a wheel has one number of teeth
            teeth = context.whole(line.place, own)
            if teeth is not None and teeth >= _FEWEST:
                yield from _mesh(context, gear.name, own, float(teeth), line.place, log_odds=_WHOLE)


def _stated_orders(teeth: Sequence[Planetary | Spur | Worm | Belt]) -> list[float]:
    """Return the mesh orders of all stages of a gear, on its output."""
    later = [prod(stage.ratio for stage in teeth[index + 1 :]) for index in range(len(teeth))]
    return [stage.mesh_order_out * ratio for stage, ratio in zip(teeth, later, strict=True)]


def _mesh(
    context: Context, gear: str, turns: float, teeth: float, place: Place | None, *, log_odds: float
) -> Iterator[Addition]:
    name = free_name(context.rig, "gear_mesh")
    multiples: Mapping[int, Place | None] = (
        {1: None} if place is None else context.multiples(place, most=_HARMONICS)
    )  # fmt: skip
    side, places = _side_lines(context, turns, teeth, multiples)

    def mesh(errors: tuple[float, ...]) -> mechanisms.GearMesh:
        return mechanisms.GearMesh(
            name=name, gear=gear, order_output=teeth, transmission_error=errors, planets=side or 1,
            planet_modulation=_MODULATION if side else 0.0,
        )  # fmt: skip

    found = harmonics(
        context, multiples, unit=lambda multiple: mesh((*(0.0,) * (multiple - 1), 1.0)),
        knob=lambda multiple: Knob(name, "transmission_error", DECADE, key=multiple - 1),
    )  # fmt: skip
    if 1 in found.medians:
        modulated = (Knob(name, "planet_modulation", _MODULATION_SPREAD),) if side else ()
        yield Addition(
            mechanism="gear_mesh", parts=(mesh(found.row()),), knobs=(*found.knobs, *modulated), log_odds=log_odds,
            starts=((*found.start, *(0.0,) * len(modulated)),), places=(*filter(None, multiples.values()), *places),
            label=f"a transmission error of {gear} at order {teeth:g} of its output",
            fixed={"order_output": (teeth, 0.0, "1/rev")},
            reported=(Reported("transmission_error_rad", "transmission_error", "rad", key=0),),
        )  # fmt: skip


def _side_lines(
    context: Context, turns: float, teeth: float, multiples: Mapping[int, Place | None]
) -> tuple[int, tuple[Place, ...]]:
    """Return the distance of found pairs of side lines from the mesh [1/rev], 0 where there are none, and the lines.

    They are looked for relative to the found mesh: all lines of a run share the error of its angle.
    """
    others = [line.place for line in context.lines if line.place.domain == "order"]
    others = [place for place in others if place not in multiples.values()]
    best, distance = list[Place](), 0
    for side in _SIDES:
        own = list[Place]()
        for multiple, place in multiples.items():
            whole = multiple * teeth
            unit = place.at / whole if place else turns
            pair = [_nearest(context, others, (whole + way * side) * unit) for way in (-1, 1)]
            own += [each for each in pair if each is not None] if None not in pair else []
        if len(own) > len(best):
            best, distance = own, side
    return distance, tuple(best)


def _nearest(context: Context, places: Sequence[Place], order: float) -> Place | None:
    """Return a place at an order of the motor, None where there is none."""
    near = max(SAME_MULTIPLE * order, context.order_step)
    return next((each for each in places if abs(each.at - order) < near), None)
