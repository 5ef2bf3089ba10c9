"""Gear mesh: a kinematic error of a gear at a whole order of its output shaft."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnosis.fitting.knobs import Knob
from torquerig.diagnosis.linear.twin import Twin
from torquerig.diagnosis.looking.places import Place
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.shafts import whole_order
from torquerig.rig.parts.gear_stage import GearStage

_LOG_ODDS = -6.5  # of this whole number of teeth
_FEWEST = 8  # teeth of a wheel
_HARMONICS = 4


def propose(context: Context) -> Iterator[Addition]:
    """Yield a transmission error for each found order that is whole on the output of a gear."""
    turns = Twin(context.rig).turns
    for gear in context.rig.parts:
        own = turns.get(context.rig.node(gear.name), 0.0) if isinstance(gear, GearStage) else 0.0
        for line in context.lines if own and gear.kind != "belt" else ():
            teeth = whole_order(line.place.at / own) if line.place.domain == "order" else None
            if teeth is not None and teeth >= _FEWEST:
                yield from _mesh(context, gear.name, teeth, context.multiples(line.place, most=_HARMONICS))


def _mesh(context: Context, gear: str, teeth: int, multiples: dict[int, Place]) -> Iterator[Addition]:
    name = free_name(context.rig, "gear_mesh")

    def mesh(errors: tuple[float, ...]) -> mechanisms.GearMesh:
        return mechanisms.GearMesh(name=name, gear=gear, order_output=float(teeth), transmission_error=errors)

    found = harmonics(
        context, multiples, unit=lambda multiple: mesh((*(0.0,) * (multiple - 1), 1.0)),
        knob=lambda multiple: Knob(name, "transmission_error", DECADE, key=multiple - 1),
    )  # fmt: skip
    if 1 in found.medians:
        yield Addition(
            mechanism="gear_mesh", parts=(mesh(found.row()),), knobs=tuple(found.knobs), starts=(tuple(found.start),),
            places=tuple(multiples.values()), log_odds=_LOG_ODDS,
            label=f"a transmission error of {gear} at order {teeth} of its output",
            fixed={"order_output": (float(teeth), 0.0, "1/rev")},
            reported=(Reported("transmission_error_rad", "transmission_error", "rad", key=0),),
        )  # fmt: skip
