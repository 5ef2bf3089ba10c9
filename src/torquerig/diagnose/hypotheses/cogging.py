"""Cogging: torque between magnets and teeth, at the orders that slots and poles allow, whatever the current."""

from __future__ import annotations

from collections.abc import Iterator
from math import lcm

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case, left_line, line_factor
from torquerig.diagnose.fitting.knobs import Knob
from torquerig.diagnose.looking.places import Place
from torquerig.rig.parts import Motor

_START = 0.001  # [N m]
_MULTIPLES = 6  # of slots or poles that are looked at, and all of them up to ...
_NATIVE = 3  # ... so many times the native order


def propose(case: Case) -> Iterator[Candidate]:
    """Yield cogging for each motor whose slots and poles are known, where left lines stand at its orders."""
    for motor in case.nominal.parts_of(Motor):
        if motor.slots is None or motor.pole_pairs is None:
            continue
        poles = 2 * motor.pole_pairs
        native = lcm(motor.slots, poles)
        furthest = {count: max(_MULTIPLES * count, _NATIVE * native) for count in (motor.slots, poles)}
        multiples = {at for count, last in furthest.items() for at in range(count, last + 1, count)}
        orders = dict.fromkeys((native, motor.slots, poles, *sorted(multiples)))
        seen = {at: place for at in orders if (place := left_line(case, float(at))) is not None}
        if not seen:
            continue
        part = mechanisms.Cogging(name="cogging", at=motor.name, slots=motor.slots, pole_pairs=motor.pole_pairs)
        part = part.with_amplitudes(dict.fromkeys(seen, _START))
        sizes = {at: _START * line_factor(case, case.model.rig + part, place) for at, place in seen.items()}
        held = [part.held_by(at) for at in sizes]
        yield Candidate(
            mechanism="cogging",
            parts=(part.with_amplitudes(sizes),),
            knobs=tuple(Knob(part.name, field, 1.0, key=key) for field, key in held),
            place=_clearest(case, seen),
        )


def _clearest(case: Case, seen: dict[int, Place]) -> Place:
    return next(peak.place for peak in case.left if peak.place in seen.values())
