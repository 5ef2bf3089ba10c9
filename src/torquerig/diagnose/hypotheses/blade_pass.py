"""Blades: one pulse of load per blade, at a whole order of the wear part, with harmonics in a fixed proportion."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from torquerig import mechanisms
from torquerig.diagnose.case import SLOW_TORQUE, Candidate, Case, left_line, line_factor, missed_lines
from torquerig.diagnose.fitting.knobs import Knob
from torquerig.diagnose.linear.loaded_part import loaded_part
from torquerig.diagnose.linear.twin import Twin
from torquerig.diagnose.looking.places import SAME_ORDER

_STRONGEST = 5
_MISSED = 2  # of the rig's own lines
_MOST_BLADES = 60
_START = 0.1  # [N m]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield blades for each of the strongest lines at a whole order of the loaded part, as first or second harmonic.

    As many blades as the gear has turns to one, or a multiple, stand on the rig's own lines alone: of these the worst
    missed count as well.
    """
    at = loaded_part(case.nominal)
    if at is None:
        return
    turns = Twin(case.nominal).turns[case.nominal.node(at)]
    tried: set[int] = set()
    left = [peak.place for peak in case.left if peak.place.domain == "order"][:_STRONGEST]
    for place in (*left, *missed_lines(case)[:_MISSED]):
        for harmonic in (1, 2):
            blades = place.at / turns / harmonic
            whole = round(blades)
            if not 1 <= whole <= _MOST_BLADES or abs(blades - whole) * turns > SAME_ORDER or whole in tried:
                continue
            tried.add(whole)
            part = mechanisms.BladePass(name="blade_pass", at=at, order_output=float(whole), amplitude=_START)
            amplitude = _START * line_factor(case, case.model.rig + part, place)
            first = left_line(case, whole * turns)  # half as many blades are another hypothesis
            yield Candidate(
                mechanism="blade_pass",
                parts=(replace(part, amplitude=amplitude),),
                knobs=(Knob(part.name, "amplitude", 1.0),),
                place=first,
                loosens=() if place in left else SLOW_TORQUE,  # which lines of the rig's own cannot tell from it
            )
