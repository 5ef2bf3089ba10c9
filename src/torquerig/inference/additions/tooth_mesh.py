"""Tooth mesh: the transmission error of stated teeth, with what planets leave of it; a variant of gear mesh."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import cos, pi

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.linear_twin.twin import Twin
from torquerig.rig.parts import Gear

NAMES = ("tooth_mesh",)

_LOG_ODDS = -3.0  # every gear has a transmission error at its teeth
_HARMONICS = 4
_PRESSURE_ANGLE = pi / 9


def propose(context: Context) -> Iterator[Addition]:
    """Yield an error of the teeth of each gear that states those of one stage."""
    turns = Twin(context.rig).turns
    for gear in context.rig.parts_of(Gear):
        own = turns.get(context.rig.node(gear.name), 0.0)
        if own and len(gear.teeth) == 1:
            yield from _mesh(context, gear, own)


def _mesh(context: Context, gear: Gear, turns: float) -> Iterator[Addition]:
    name, teeth = free_name(context.rig, "tooth_mesh"), gear.teeth[0]
    order = teeth.mesh_order_out
    at = context.at_orders(turns, (multiple * order for multiple in range(1, _HARMONICS + 1)))
    places = {round(one / order): place for one, place in at.items()}
    module = 2 / (cos(_PRESSURE_ANGLE) * teeth.lever_teeth)  # a lever of 1 m: errors in m are then those in rad

    def mesh(errors: Mapping[int, float]) -> mechanisms.ToothMesh:
        every = tuple(errors.get(multiple, 0.0) for multiple in range(1, max(errors) + 1))
        return mechanisms.ToothMesh(
            name=name, gear=gear.name, module=module, pressure_angle=_PRESSURE_ANGLE, tooth_error=every
        )

    found = harmonics(
        context, places, unit=lambda multiple: mesh({multiple: 1.0}),
        knob=lambda multiple: Knob(name, "tooth_error", DECADE, key=multiple - 1),
    )  # fmt: skip
    first = next((one for one in range(1, _HARMONICS + 1) if mesh({one: 1.0}).lines(teeth)), 0)
    if first in found.medians:  # the lowest multiple that the planets leave; others alone are no mesh
        yield Addition(
            mechanism="gear_mesh", variant="tooth_mesh", parts=(mesh(found.medians),), knobs=tuple(found.knobs),
            starts=(tuple(found.start),), places=tuple(places.values()), log_odds=_LOG_ODDS,
            label=f"a transmission error of the teeth of {gear.name}, order {order:g} of its output",
            fixed={"order_output": (float(order), 0.0, "1/rev")},
            reported=(Reported("transmission_error_rad", "tooth_error", "rad", key=first - 1),),
        )  # fmt: skip
