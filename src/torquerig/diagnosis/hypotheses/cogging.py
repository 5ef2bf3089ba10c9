"""Cogging: torque between magnets and teeth, at the orders that slots and poles allow, whatever the current."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case, left_line, line_factor
from torquerig.diagnosis.hypotheses.motor_orders import BY_SKIRTS, STRONG, cogging_orders, native_order
from torquerig.inference.knobs import Knob
from torquerig.inference.places import SAME_ORDER, Place, order
from torquerig.rig.parts import Motor

_START = 0.001  # [N m]
_OF_THE_FIRST = 0.1  # at which a harmonic is started that shows in bands alone
_SKIRTED = 0.005  # [N m] at which one that shows no line is started
_UNEVEN = 5.0  # what lines must gain beside that only magnets or teeth unlike their neighbours make


def propose(case: Case) -> Iterator[Candidate]:
    """Yield cogging for each motor whose slots and poles are known, where left lines stand at its orders.

    Where a strong one smears, for want of an encoder, with twice its order too, which then smears more and shows in
    bands. Where none stands there, at its native order: an unsteady speed may leave noise beside that line alone.
    """
    for motor in case.nominal.parts_of(Motor):
        if motor.slots is None or motor.pole_pairs is None:
            continue
        native = native_order(motor)
        seen = {at: place for at in cogging_orders(motor) if (place := left_line(case, float(at))) is not None}
        part = mechanisms.Cogging(name="cogging", at=motor.name, slots=motor.slots, pole_pairs=motor.pole_pairs)
        if not seen:
            yield from _by_its_skirts(case, part, native)
            continue
        part = part.with_amplitudes(dict.fromkeys(seen, _START))
        sizes = {at: _START * line_factor(case, case.model.rig + part, place) for at, place in seen.items()}
        clearest = next(peak for peak in case.left if peak.place in seen.values())
        yield _cogging(part, sizes, place=clearest.place, native=native)
        smeared = {2 * at: _OF_THE_FIRST * size for at, size in sizes.items() if 2 * at not in seen}
        if clearest.excess > STRONG and smeared and not all(run.angle_measured for run in case.runs if run.steady):
            yield _cogging(part, {**sizes, **smeared}, place=clearest.place, native=native)


def _cogging(part: mechanisms.Cogging, sizes: dict[int, float], *, place: Place, native: int) -> Candidate:
    """Return the cogging with amplitudes [N m] of lines that are fitted."""
    return Candidate(
        mechanism="cogging",
        parts=(part.with_amplitudes(sizes),),
        knobs=tuple(Knob(part.name, field, 1.0, key=key) for field, key in map(part.held_by, sizes)),
        place=place,
        price=0.0 if round(place.at) % native == 0 else _UNEVEN,
    )


def _by_its_skirts(case: Case, part: mechanisms.Cogging, native: int) -> Iterator[Candidate]:
    """Yield cogging at the native order where no run has a place for its line."""
    shown = [place.at for place in case.seen[0].places if place.domain == "order"]
    if not any(abs(at - native) < SAME_ORDER for at in shown):
        field, key = part.held_by(native)
        yield Candidate(
            mechanism="cogging",
            parts=(part.with_amplitudes({native: _SKIRTED}),),
            knobs=(Knob(part.name, field, 1.0, key=key),),
            place=order(native),
            price=BY_SKIRTS,
        )
