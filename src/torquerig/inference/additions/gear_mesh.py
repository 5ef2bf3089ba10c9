"""Gear mesh: a kinematic error of a gear at a whole order of its output shaft."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnosis.fitting.knobs import Knob
from torquerig.diagnosis.linear.twin import Twin
from torquerig.diagnosis.looking.places import Place
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.rig.parts.gear_stage import gear_stages

NAMES = ("gear_mesh",)

_STATED, _WHOLE, _OTHER = -3.0, -6.5, -11.0  # log-odds at the stated number of teeth, of a gear that states none, and
# at a whole number that contradicts the stated one
_FEWEST = 8  # teeth of a wheel
_HARMONICS = 4
_SIDES = (1, 2, 3, 4, 5)  # times a turn that a mesh may be stronger: a wheel off its centre, an oval one, planets
_MODULATION, _MODULATION_SPREAD = 0.2, 1.0  # prior median, and of its logarithm


def propose(context: Context) -> Iterator[Addition]:
    """Yield a transmission error for each found order that is whole on the output of a gear."""
    turns = Twin(context.rig).turns
    for gear in gear_stages(context.rig):
        own = turns.get(context.rig.node(gear.name), 0.0)
        stated = {round(stage.mesh_order_out) for stage in gear.teeth}
        for line in context.lines if own and gear.kind != "belt" else ():
            teeth = context.whole(line.place, own)
            if teeth is not None and teeth >= _FEWEST:
                odds = _STATED if teeth in stated else _OTHER if stated else _WHOLE
                multiples = context.multiples(line.place, most=_HARMONICS)
                yield from _mesh(context, gear.name, own, teeth, multiples, log_odds=odds)


def _mesh(
    context: Context, gear: str, turns: float, teeth: int, multiples: dict[int, Place], *, log_odds: float
) -> Iterator[Addition]:
    name = free_name(context.rig, "gear_mesh")
    side, places = _side_lines(context, turns, teeth, multiples)

    def mesh(errors: tuple[float, ...]) -> mechanisms.GearMesh:
        return mechanisms.GearMesh(
            name=name, gear=gear, order_output=float(teeth), transmission_error=errors, planets=side or 1,
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
            starts=((*found.start, *(0.0,) * len(modulated)),), places=(*multiples.values(), *places),
            label=f"a transmission error of {gear} at order {teeth} of its output",
            fixed={"order_output": (float(teeth), 0.0, "1/rev")},
            reported=(Reported("transmission_error_rad", "transmission_error", "rad", key=0),),
        )  # fmt: skip


def _side_lines(
    context: Context, turns: float, teeth: int, multiples: dict[int, Place]
) -> tuple[int, tuple[Place, ...]]:
    """Return the distance of found pairs of side lines from the mesh [1/rev], 0 where there are none, and the lines."""
    best, distance = dict[float, Place](), 0
    for side in _SIDES:
        pairs = [(float(multiple * teeth - side), float(multiple * teeth + side)) for multiple in multiples]
        own = context.at_orders(turns, (order for pair in pairs for order in pair))
        own = {order: own[order] for pair in pairs if own.keys() >= set(pair) for order in pair}
        if len(own) > len(best):
            best, distance = own, side
    return distance, tuple(place for place in best.values() if place not in multiples.values())
