"""Eccentricity: a rotor off the centre of its stator, whose teeth then pull unequally; a variant of cogging."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import exp

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name, start_of
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.rig.parts import Motor

NAMES = ("eccentricity",)

_LOG_ODDS = -5.0
_STATIC, _DYNAMIC = 0.1, 0.03  # of the magnetic gap: prior medians
_SPREAD = 0.7  # of their logarithms
_AT = (-1.0, 0.5, 2.0)  # [standard deviations] of both where a fit begins
_FEWEST = 2  # lines; a single one is one of cogging


def propose(context: Context) -> Iterator[Addition]:
    """Yield an offset rotor for each motor that shows several of the lines that it makes."""
    for motor in context.rig.parts_of(Motor):
        if motor.slots and motor.pole_pairs:
            yield from _off_centre(context, motor.name, motor.slots, motor.pole_pairs)


def _off_centre(context: Context, motor: str, slots: int, pairs: int) -> Iterator[Addition]:
    name = free_name(context.rig, "eccentricity")

    def off(tooth: float, static: float = _STATIC, dynamic: float = _DYNAMIC) -> mechanisms.Eccentricity:
        return mechanisms.Eccentricity(
            name=name, at=motor, slots=slots, pole_pairs=pairs, tooth_torque=tooth, static=static, dynamic=dynamic
        )

    amplitudes = off(1.0).amplitudes()
    lines = context.at_orders(1.0, map(float, amplitudes))
    if len(lines) < _FEWEST:
        return
    largest = round(max(lines, key=lambda order: amplitudes[round(order)]))
    value, median = context.size_of(off(1.0), lines[largest])
    starts = list[tuple[float, ...]]()
    for at in product(_AT, _AT) if median else ():  # each with the tooth whose largest line has the size found
        static, dynamic = (middle * exp(_SPREAD * one) for middle, one in zip((_STATIC, _DYNAMIC), at, strict=True))
        line = off(1.0, static, dynamic).amplitudes().get(largest, 0.0)
        starts += [(start_of(value * amplitudes[largest] / line, median), *at)] if line else []
    if starts:
        shares = Knob(name, "static", _SPREAD), Knob(name, "dynamic", _SPREAD)
        yield Addition(
            mechanism="cogging", variant="eccentricity", parts=(off(median),), places=tuple(lines.values()),
            knobs=(Knob(name, "tooth_torque", DECADE), *shares), starts=tuple(starts), log_odds=_LOG_ODDS,
            label=f"a rotor of {motor} off the centre of its stator",
            fixed={"order_motor": (float(largest), 0.0, "1/rev")},
            reported=(Reported("tooth_torque_Nm", "tooth_torque", "N*m"), Reported("static", "static", "1"),
                      Reported("dynamic", "dynamic", "1")),
        )  # fmt: skip
