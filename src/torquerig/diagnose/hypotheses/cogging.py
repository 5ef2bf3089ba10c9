"""Cogging: torque between magnets and teeth, at the orders that slots and poles allow, whatever the current."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import lcm
from typing import Any

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case, left_line, line_factor
from torquerig.diagnose.knobs import Knob
from torquerig.rig.parts import Motor

_START = 0.001  # [N m]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield cogging for each motor whose slots and poles are known, where a left line stands at one of its orders."""
    for motor in case.nominal.parts_of(Motor):
        if motor.slots is None or motor.pole_pairs is None:
            continue
        orders = {
            "native": lcm(motor.slots, 2 * motor.pole_pairs),
            "unequal_magnets": motor.slots,
            "unequal_teeth": 2 * motor.pole_pairs,
        }
        places = {field: left_line(case, float(at)) for field, at in orders.items()}
        seen = {field: place for field, place in places.items() if place is not None}
        if not seen:
            continue
        part = mechanisms.Cogging(name="cogging", at=motor.name, slots=motor.slots, pole_pairs=motor.pole_pairs)
        part = _with(part, dict.fromkeys(seen, _START))
        sizes = {field: _START * line_factor(case, case.model.rig + part, place) for field, place in seen.items()}
        yield Candidate(
            mechanism="cogging",
            parts=(_with(part, sizes),),
            knobs=tuple(Knob(part.name, field, 1.0) for field in seen),
            place=next(iter(seen.values())),
        )


def _with(part: mechanisms.Cogging, sizes: dict[str, float]) -> mechanisms.Cogging:
    changes: dict[str, Any] = dict(sizes)
    return replace(part, **changes)
