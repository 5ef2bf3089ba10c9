"""Ripple in proportion to the motor's torque: a line at a whole motor order that grows with the load."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case, left_line, line_factor, missed_lines
from torquerig.diagnosis.hypotheses.motor_orders import BY_SKIRTS
from torquerig.inference.knobs import Knob
from torquerig.inference.places import SAME_ORDER, WHOLE_ORDER, Place, order
from torquerig.rig.assembly import Part
from torquerig.rig.parts import Motor

_STRONGEST, _MISSED = 5, 2  # of the left lines, and of the rig's own
_MAIN = (6, 12)  # field orders of a six-step drive
_UNBALANCED = (1, 2)  # those of phases that are not alike
_SKIRTED, _OF_FIRST = 0.05, 0.25  # [1] depth at which one that shows no line is started, its second harmonic to it
_START = 0.01
_HARMONICS = 4
_BESIDE_THE_FIELD = 100.0  # no current of the motor turns so: what else it may be is likelier, if not by far the worse
_NO_HARMONIC = 20.0  # balanced phases have torque at 6p and its multiples alone, offsets of current p, unequal gains 2p
_TWELFTH_ALONE = 3.0  # six steps make the sixth field order first, so few rigs show the twelfth without it
_DEEPEST = 1.0  # of the motor's torque: six steps leave half of it at most (Carlson 1992), told to a factor of two
_DEEP = 0.7  # beyond half and what fits tell
TOLD_LOOSELY = {"depth": -1.0}  # at one speed no better than what the rig passes on at the line's frequency


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a ripple for each of the strongest lines at a whole motor order.

    Currents, their offsets and unequal gains all turn with the field: p, 2p and the multiples of 6p; other multiples
    pay, orders that no current has pay more, and so does 12p where no line at 6p leads it. An unsteady load leaves
    noise beside twice the order too, where a second harmonic stands out as no line: that is asked apart. So are the
    rig's own lines at such orders that the model misses: one that grows with the load is no line of its own.
    """
    motors = case.nominal.parts_of(Motor)
    if motors:
        yield from _by_its_skirts(case, motors[0])
    for place in _of_the_motor(case, motors[0]) if motors else []:
        if abs(place.at - round(place.at)) < WHOLE_ORDER:
            part = mechanisms.CommutationRipple(
                name="commutation_ripple", at=motors[0].name, order_motor=float(round(place.at)), depth=_START
            )
            part = replace(part, depth=_START * line_factor(case, case.model.rig + part, place))
            part, harmonics = _with_harmonics(case, part)
            of_lines = Candidate(
                mechanism="commutation_ripple",
                parts=(part,),
                knobs=(Knob(part.name, "depth", 1.0), *harmonics),
                place=place,
                price=_price(motors[0], place.at),
            )
            yield of_lines
            if not harmonics and of_lines.price == 0:
                yield _with_second(of_lines, part)


def _of_the_motor(case: Case, motor: Motor) -> list[Place]:
    """Return the strongest left lines of an order, and of the weaker and the missed ones those where a field's may be.

    Coarse codes make more lines than anyone tries.
    """
    lines = [peak.place for peak in case.left if peak.place.domain == "order"]
    others = [*lines[_STRONGEST:], *missed_lines(case)[:_MISSED]]
    return [
        *lines[:_STRONGEST],
        *(place for place in others if motor.pole_pairs and _price(motor, place.at) < _NO_HARMONIC),
    ]


def _by_its_skirts(case: Case, motor: Motor) -> Iterator[Candidate]:
    """Yield a ripple of each main field order whose line is none or small: an unsteady load leaves noise beside it."""
    modelled = [place for place in case.seen[0].places if place not in case.seen[0].unknown]
    shown = [place.at for place in (*modelled, *(peak.place for peak in case.left)) if place.domain == "order"]
    for multiple in _MAIN:
        order_motor = float(multiple * (motor.pole_pairs or 0))
        if order_motor and not any(abs(each - order_motor) < SAME_ORDER for each in shown):
            part = mechanisms.CommutationRipple(
                name="commutation_ripple", at=motor.name, order_motor=order_motor, depth=_SKIRTED
            )
            alone = Candidate(
                mechanism="commutation_ripple", parts=(part,), knobs=(Knob(part.name, "depth", 1.0),),
                place=order(order_motor), price=_price(motor, order_motor) + BY_SKIRTS,
            )  # fmt: skip
            yield alone
            yield _with_second(alone, part)


def _with_second(alone: Candidate, part: mechanisms.CommutationRipple) -> Candidate:
    """Return the candidate with a second harmonic, which stands out as no line."""
    second = replace(part, harmonics=(_OF_FIRST * part.depth,))
    return replace(alone, parts=(second,), knobs=(*alone.knobs, Knob(part.name, "harmonics", 1.0, key=0)))


def _price(motor: Motor, order_motor: float) -> float:
    """Return what a ripple whose lowest line stands at a whole motor order must gain beside."""
    if not motor.pole_pairs:
        return 0.0
    multiple, beside = divmod(round(order_motor), motor.pole_pairs)
    if beside:
        return _BESIDE_THE_FIELD
    if multiple not in _UNBALANCED and multiple % _MAIN[0]:
        return _NO_HARMONIC
    return _TWELFTH_ALONE if multiple == _MAIN[1] else 0.0


def _with_harmonics(case: Case, part: mechanisms.CommutationRipple) -> tuple[mechanisms.CommutationRipple, list[Knob]]:
    """Return the ripple with those of its harmonics that stand among the left lines, and their knobs."""
    seen = {h: place for h in range(2, _HARMONICS + 1) if (place := left_line(case, h * part.order_motor))}
    depths = [0.0] * (max(seen, default=1) - 1)
    for multiple, place in seen.items():
        alone = replace(part, order_motor=multiple * part.order_motor, depth=_START)
        depths[multiple - 2] = _START * line_factor(case, case.model.rig + alone, place)
    return replace(part, harmonics=tuple(depths)), [Knob(part.name, "harmonics", 1.0, key=h - 2) for h in seen]


def possible(part: Part) -> bool:
    """Whether a ripple could be: no drive turns its torque round within a turn."""
    return isinstance(part, mechanisms.CommutationRipple) and part.depth < _DEEPEST


def likely(part: Part) -> bool:
    """Whether a ripple is one that drives make; one that passes what six steps leave is not, but for a bad fit."""
    return isinstance(part, mechanisms.CommutationRipple) and part.depth < _DEEP
