"""Lines of one order on one shaft: their sum depends on the phase between them, which is the same in all runs.

Two torques of amplitudes a and b that turn with one shaft leave ``|H_a a + H_b b exp(i phi)|^2`` in the reading. Nobody
states phi; it is a parameter. Where the shafts turn in another ratio, each start finds another phase.
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
_ONE_SHAFT = 1e-9  # [1] relative difference of two speeds that are the same


def with_phases(rig: Rig) -> Rig:
    """Return the rig with phases of the lines that share order and shaft, where none is stated."""
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
    """Return part, order and whether it is the first, of lines on shafts that turn as the motor and share an order."""
    turns = Twin(rig).turns
    lines = [
        (ripple.name, order) for ripple in rig.parts_of(TorqueRipple)
        if abs(turns.get(rig.node(ripple.at), 0.0) - 1) < _ONE_SHAFT for order in ripple.amplitudes
    ]  # fmt: skip
    orders = [order for _, order in lines]
    return [
        (part, order, orders.index(order) == at) for at, (part, order) in enumerate(lines) if orders.count(order) > 1
    ]
