"""Cogging: torque between magnets and teeth, at the orders that slots and poles allow, whatever the current."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import lcm
from typing import Any

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case, left_line, line_factor
from torquerig.diagnose.knobs import Knob
from torquerig.diagnose.places import Place
from torquerig.rig.parts import Motor

_START = 0.001  # [N m]
_MULTIPLES = 6  # of slots or poles that are looked at


def propose(case: Case) -> Iterator[Candidate]:
    """Yield cogging for each motor whose slots and poles are known, where left lines stand at its orders."""
    for motor in case.nominal.parts_of(Motor):
        if motor.slots is None or motor.pole_pairs is None:
            continue
        poles = 2 * motor.pole_pairs
        named: dict[int, tuple[str, int | None]] = {
            lcm(motor.slots, poles): ("native", None),
            motor.slots: ("unequal_magnets", None),
            poles: ("unequal_teeth", None),
        }
        multiples = {count * times for count in (motor.slots, poles) for times in range(2, _MULTIPLES + 1)}
        named |= {order: ("further", order) for order in sorted({*multiples, 2 * lcm(motor.slots, poles)} - {*named})}
        seen = {at: place for at in named if (place := left_line(case, float(at))) is not None}
        if not seen:
            continue
        part = mechanisms.Cogging(name="cogging", at=motor.name, slots=motor.slots, pole_pairs=motor.pole_pairs)
        part = _with(part, {named[at]: _START for at in seen})
        sizes = {named[at]: _START * line_factor(case, case.model.rig + part, place) for at, place in seen.items()}
        yield Candidate(
            mechanism="cogging",
            parts=(_with(part, sizes),),
            knobs=tuple(Knob(part.name, field, 1.0, key=key) for field, key in sizes),
            place=_clearest(case, seen),
        )


def _with(part: mechanisms.Cogging, sizes: dict[tuple[str, int | None], float]) -> mechanisms.Cogging:
    changes: dict[str, Any] = {field: size for (field, key), size in sizes.items() if key is None}
    changes["further"] = {key: size for (_, key), size in sizes.items() if key is not None}
    return replace(part, **changes)


def _clearest(case: Case, seen: dict[int, Place]) -> Place:
    return next(peak.place for peak in case.left if peak.place in seen.values())
