"""Lines of one order of the motor: their sum depends on the phase between them, which is the same in all runs.

Two torques of amplitudes a and b that turn with one shaft leave ``|H_a a + H_b b exp(i phi)|^2`` in the reading. Nobody
states phi; it is a parameter. Gears and toothed belts hold the angle of a shaft to that of another, so that a line of
order k on a shaft that turns n / k times as fast as the motor is a line of order n of it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import pi

from torquerig.inference.knobs import Knob
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import TorqueRipple
from torquerig.rig.assembly import Rig

_SQUARE = 0.5 * pi  # [rad] between two lines whose powers add
_SPREAD = 1.2  # [rad] about it: that lines oppose each other is as likely as that they add
_DIGITS = 9  # of an order: lines that differ later have the same one


def with_phases(rig: Rig) -> Rig:
    """Return the rig with phases of the lines that share an order of the motor, where none is stated."""
    for part, order, first in _shared(rig):
        ripple = rig.part(part)
        if isinstance(ripple, TorqueRipple) and order not in ripple.phases:
            phases = {**ripple.phases, order: 0.0 if first else _SQUARE}
            rig = rig.changed(replace(ripple, phases=phases))
    return rig


def phases(rig: Rig) -> Iterator[Knob]:
    """Yield the phases that ``with_phases`` gave."""
    for part, order, first in _shared(rig):
        if not first and getattr(rig.part(part), "phases", {}).get(order) == _SQUARE:
            yield Knob(part, "phases", _SPREAD, key=order, factor=False)


def _shared(rig: Rig) -> list[tuple[str, float, bool]]:
    """Return part, order and whether it is the first, of lines that have one order of the motor."""
    turns = Twin(rig).turns
    lines = [
        (ripple.name, order, abs(turns[rig.node(ripple.at)] * order))
        for ripple in rig.parts_of(TorqueRipple)
        if rig.node(ripple.at) in turns
        for order in ripple.amplitudes
    ]
    orders = [round(each, _DIGITS) for _, _, each in lines]
    return [
        (part, order, orders.index(orders[at]) == at)
        for at, (part, order, _) in enumerate(lines) if orders.count(orders[at]) > 1
    ]  # fmt: skip
