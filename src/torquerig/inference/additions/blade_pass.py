"""Blade pass: one pulse of load per blade, whose harmonics have known sizes."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnosis.fitting.knobs import Knob
from torquerig.diagnosis.looking.places import Place
from torquerig.inference.addition import DECADE, Addition, Reported, free_name, start_of
from torquerig.inference.context import Context
from torquerig.inference.shafts import Shaft

NAMES = ("blade_pass",)

_LOG_ODDS = -5.0  # of this number of blades
_MOST = 24  # blades
_HARMONICS = 3  # of a pulse: 100, 35 and 4 % of the power of the first; the others have less than 0.1 %


def propose(context: Context) -> Iterator[Addition]:
    """Yield pulses at the last shaft for each number of blades of which a found order is one of the first harmonics."""
    shaft, tried = context.shafts[-1], set[int]()
    for line in context.lines:
        order = context.whole(line.place, shaft.turns)
        for harmonic in range(1, _HARMONICS + 1):
            blades = 0 if order is None or order % harmonic else order // harmonic
            if 1 < blades <= _MOST and blades not in tried:
                tried.add(blades)
                yield from _blades(context, shaft, blades, line.place)


def _blades(context: Context, shaft: Shaft, blades: int, place: Place) -> Iterator[Addition]:
    name = free_name(context.rig, "blade_pass")
    unit = mechanisms.BladePass(name=name, at=shaft.part, order_output=float(blades), amplitude=1.0)
    value, median = context.size_of(unit, place)
    if median:
        lines = context.at_orders(shaft.turns, (float(blades * one) for one in range(1, _HARMONICS + 1)))
        yield Addition(
            mechanism="blade_pass", knobs=(Knob(name, "amplitude", DECADE),), starts=((start_of(value, median),),),
            parts=(mechanisms.BladePass(name=name, at=shaft.part, order_output=float(blades), amplitude=median),),
            places=tuple(lines.values()),
            log_odds=_LOG_ODDS, label=f"a load pulse of each of {blades} blades at {shaft.part}",
            fixed={"order_output": (float(blades), 0.0, "1/rev")},
            reported=(Reported("amplitude_Nm", "amplitude", "N*m"),),
        )  # fmt: skip
