"""Ripple in proportion to the motor's torque: a line at a whole motor order that grows with the load."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case, line_factor
from torquerig.diagnose.knobs import Knob
from torquerig.diagnose.places import SAME_ORDER
from torquerig.rig.part import Part
from torquerig.rig.parts import Motor

_STRONGEST = 5
_START = 0.01
_BESIDE_THE_FIELD = 20.0
_DEEPEST = 1.2  # of the motor's torque


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a ripple for each of the strongest lines at a whole motor order.

    Currents, their offsets and unequal gains all turn with the field: p, 2p, 6p and their multiples; other orders pay.
    """
    motors = case.nominal.parts_of(Motor)
    for peak in [peak for peak in case.left if peak.place.domain == "order"][:_STRONGEST]:
        if motors and abs(peak.place.at - round(peak.place.at)) < SAME_ORDER:
            electrical = round(peak.place.at) % (motors[0].pole_pairs or 1) == 0
            part = mechanisms.CommutationRipple(
                name="commutation_ripple", at=motors[0].name, order_motor=float(round(peak.place.at)), depth=_START
            )
            depth = _START * line_factor(case, case.model.rig + part, peak.place)
            yield Candidate(
                mechanism="commutation_ripple",
                parts=(replace(part, depth=depth),),
                knobs=(Knob(part.name, "depth", 1.0),),
                place=peak.place,
                price=0.0 if electrical else _BESIDE_THE_FIELD,
            )


def possible(part: Part) -> bool:
    """Whether a ripple could be: no drive turns its torque round within a turn."""
    return isinstance(part, mechanisms.CommutationRipple) and part.depth < _DEEPEST
