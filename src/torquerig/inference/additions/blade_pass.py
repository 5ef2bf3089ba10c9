"""Blade pass: one pulse of load per blade, whose harmonics have known sizes."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.inference.places import Place
from torquerig.inference.shafts import Shaft

NAMES = ("blade_pass",)

_ONE_WAY = -6.5  # of pulses that push against forward motion, as those of a pump
_LOG_ODDS = -5.0  # of this number of blades: one in seven loads has some that nobody stated, 2 to 24
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
    """Yield pulses against the motion and, where the runs turn both ways, some that push one way."""
    name = free_name(context.rig, "blade_pass")
    lines = context.at_orders(shaft.turns, (float(blades * one) for one in range(1, _HARMONICS + 1)))
    for one_way in (False, True) if context.turns_both_ways else (False,):

        def pulses(size: float, one_way: bool = one_way) -> mechanisms.BladePass:
            return mechanisms.BladePass(
                name=name, at=shaft.part, order_output=float(blades), amplitude=size, one_way=one_way
            )

        yield from one_size(
            context, pulses, field="amplitude", place=place, places=lines.values(), mechanism="blade_pass",
            variant="one_way" if one_way else "", log_odds=_ONE_WAY if one_way else _LOG_ODDS,
            label=f"a load pulse of each of {blades} blades at {shaft.part}",
            fixed={"order_output": (float(blades), 0.0, "1/rev")},
            reported=(Reported("amplitude_Nm", "amplitude", "N*m"),),
        )  # fmt: skip
