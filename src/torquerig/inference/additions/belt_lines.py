"""Belt lines: the turn of a belt, its teeth, and pulleys that run out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.linear_twin.twin import Twin
from torquerig.rig.parts import BeltStage

NAMES = ("belt_lines",)

_OF_BELT, _OF_PULLEY = -4.0, -5.5  # log-odds: a joint or worn teeth of the belt, and one pulley off its centre
_MULTIPLES = 4  # of the turn of the belt
_TEETH, _WHEEL, _PINION = 101, 102, 103  # keys next to those multiples
_RUNOUTS = {_TEETH: "tooth_error", _WHEEL: "wheel_runout", _PINION: "pinion_runout"}
_LABELS = {_WHEEL: "the output pulley of {} off its centre", _PINION: "the input pulley of {} off its centre"}


def propose(context: Context) -> Iterator[Addition]:
    """Yield the lines of each belt, and of each of its pulleys."""
    turns = Twin(context.rig).turns
    for stage in context.rig.parts_of(BeltStage):
        own, belt = turns.get(context.rig.node(stage.name), 0.0), stage.geometry()
        if not own:
            continue
        orders = {multiple: multiple * belt.belt_order_out for multiple in range(1, _MULTIPLES + 1)}
        if belt.toothed:
            orders[_TEETH] = belt.mesh_order_out
        yield from _lines(context, stage.name, own, orders, log_odds=_OF_BELT, label=f"an uneven belt of {stage.name}")
        for pulley, order in ((_WHEEL, 1.0), (_PINION, belt.ratio)):
            yield from _lines(
                context, stage.name, own, {pulley: order}, log_odds=_OF_PULLEY, label=_LABELS[pulley].format(stage.name)
            )


def _lines(
    context: Context, stage: str, turns: float, orders: Mapping[int, float], *, log_odds: float, label: str
) -> Iterator[Addition]:
    name = free_name(context.rig, "belt_lines")
    at = context.at_orders(turns, orders.values())
    places = {key: at[order] for key, order in orders.items() if order in at}

    def uneven(sizes: Mapping[int, float]) -> mechanisms.BeltLines:
        of_belt = tuple(sizes.get(multiple, 0.0) for multiple in range(1, _MULTIPLES + 1))
        teeth, wheel, pinion = (sizes.get(key, 0.0) for key in _RUNOUTS)
        return mechanisms.BeltLines(
            name=name, gear=stage, belt_error=of_belt, tooth_error=teeth, wheel_runout=wheel, pinion_runout=pinion
        )

    def field_of(key: int) -> tuple[str, int | None]:
        return (_RUNOUTS[key], None) if key in _RUNOUTS else ("belt_error", key - 1)

    found = harmonics(
        context, places, unit=lambda key: uneven({key: 1.0}),
        knob=lambda key: Knob(name, field_of(key)[0], DECADE, key=field_of(key)[1]),
    )  # fmt: skip
    if found.medians:
        first = min(found.medians)
        yield Addition(
            mechanism="belt_lines", parts=(uneven(found.medians),), knobs=tuple(found.knobs),
            starts=(tuple(found.start),), places=tuple(places.values()), log_odds=log_odds, label=label,
            fixed={"order_output": (orders[first] / (first if first <= _MULTIPLES else 1), 0.0, "1/rev")},
            reported=(Reported("error_rad", field_of(first)[0], "rad", key=field_of(first)[1]),),
        )  # fmt: skip
