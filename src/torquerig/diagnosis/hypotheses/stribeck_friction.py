"""Dry friction at the loaded part, with a peak near standstill."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import product

from torquerig import mechanisms
from torquerig.diagnosis.case import SLOW_TORQUE, Candidate, Case
from torquerig.diagnosis.fitting.profiled import profiled_cost
from torquerig.diagnosis.hypotheses.beside_steps import price_beside_steps
from torquerig.diagnosis.linear.loaded_part import loaded_part
from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Part

_COULOMB, _PEAKS, _SPEEDS = (0.03, 0.1, 0.3, 0.8), (1.1, 2.0), (0.3, 1.0, 3.0)  # [N m], [1], [rad/s]
_STATIC = 0.4  # of the logarithm: static friction is one to three times the Coulomb one, and few blocks tell it
_TWO_WAYS = 30.0  # that directions differ is a claim of its own, and near standstill no friction law is to be trusted
# a static torque below so much of the Coulomb one, up to a speed so high [rad/s], is a drag that grows with the speed;
# at lower speeds few samples tell the static torque
_RISES, _UP_TO = 0.5, 10.0
_ONE_WAY = 10.0  # times the other direction's: what slides so much more freely one way is a ratchet, not a friction
_HELD_ALONE = 10.0  # times the Coulomb torque: what holds so much and then slides so freely is a detent, not a friction


def propose(case: Case) -> Iterator[Candidate]:
    """Yield the friction curve that fits best among a few sizes, peaks and Stribeck speeds, and its like by direction.

    It is sought beside the model as fitted, whose other frictions stood in for it and give way, and beside the
    nominal one.
    """
    at = loaded_part(case.nominal)
    if at is None:
        return
    fitted = case.model.rig
    yield from _best(case, at, lambda part: profiled_cost(case.model, fitted + part, case.seen))
    nominal = case.nominal_with_accepted()
    yield from _best(case, at, lambda part: case.misfit_of(nominal + part))


def _best(case: Case, at: str, misfit: Callable[[Part], float]) -> Iterator[Candidate]:
    ranked: list[tuple[float, mechanisms.StribeckFriction]] = []
    for coulomb, peak, speed in product(_COULOMB, _PEAKS, _SPEEDS):
        part = mechanisms.StribeckFriction(
            name="stribeck_friction", at=at, coulomb=coulomb, static=coulomb * peak, stribeck_speed=speed
        )
        ranked.append((misfit(part), part))
    part = min(ranked, key=lambda item: item[0])[1]
    price = price_beside_steps(case)
    yield Candidate(mechanism="stribeck_friction", parts=(part,), knobs=_knobs(part), price=price, loosens=SLOW_TORQUE)
    if any(features.turning is not None for features in case.seen):
        own = replace(part, coulomb_backward=part.coulomb, static_backward=part.static)
        yield Candidate(
            mechanism="stribeck_friction",
            parts=(own,),
            knobs=_knobs(own),
            variant="by_direction",
            price=price + _TWO_WAYS,
            loosens=SLOW_TORQUE,
        )


def _knobs(part: mechanisms.StribeckFriction) -> tuple[Knob, ...]:
    fields = ("coulomb", "static", "stribeck_speed", "coulomb_backward", "static_backward")
    stated = (field for field in fields if getattr(part, field) is not None)
    return tuple(Knob(part.name, field, _STATIC if field.startswith("static") else 0.8) for field in stated)


def possible(part: Part) -> bool:
    """Whether a fitted curve could be dry friction, which falls as a contact begins to slide, and does not set in."""
    if not isinstance(part, mechanisms.StribeckFriction):
        return False
    sides = ((part.coulomb, part.static), (part.coulomb_backward, part.static_backward))
    stated = [(coulomb, static) for coulomb, static in sides if coulomb is not None and static is not None]
    if sum(static for _, static in stated) > _HELD_ALONE * sum(coulomb for coulomb, _ in stated):
        return False
    slid = [coulomb for coulomb, _ in stated]
    if max(slid) > _ONE_WAY * min(slid):
        return False
    rises = any(static < _RISES * coulomb for coulomb, static in stated)
    return not rises or part.stribeck_speed < _UP_TO
