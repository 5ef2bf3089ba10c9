"""Blades: one pulse of load per blade, at a whole order of the wear part, with harmonics in a fixed proportion."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from torquerig import mechanisms
from torquerig.diagnosis.case import SLOW_TORQUE, Candidate, Case, bent_lines, left_line, line_factor, missed_lines
from torquerig.diagnosis.linear.loaded_part import loaded_part
from torquerig.diagnosis.looking.pulses_both_ways import pulses_both_ways
from torquerig.inference.knobs import Knob
from torquerig.inference.places import WHOLE_ORDER, Place
from torquerig.linear_twin.twin import Twin

_STRONGEST = 5
_MISSED = 2  # of the rig's own lines
_MOST_BLADES = 60
_START = 0.1  # [N m]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield blades for each of the strongest lines at a whole order of the loaded part, as first or second harmonic.

    Some numbers of blades stand on the rig's own lines alone: of these the worst missed count as well, those whose
    amplitudes were bent to stand in for blades, and those with which a run that turns back swings both ways. Such a run
    tells as well whether they oppose the motion or push one way.
    """
    at = loaded_part(case.nominal)
    if at is None:
        return
    turns = Twin(case.nominal).turns[case.nominal.node(at)]
    tried: set[int] = set()
    left = [peak.place for peak in case.left if peak.place.domain == "order"][:_STRONGEST]
    for whole in _instead_of_own_lines(case, turns):
        tried.add(whole)
        part = mechanisms.BladePass(name="blade_pass", at=at, order_output=float(whole), amplitude=_START)
        yield from _blades(case, part, place=left_line(case, whole * turns), loosens=(*SLOW_TORQUE, "amplitudes"))
    for place in (*left, *missed_lines(case)[:_MISSED]):
        for harmonic in (1, 2):
            whole = _whole(place.at / turns / harmonic, turns)
            if not whole or whole in tried:
                continue
            tried.add(whole)
            part = mechanisms.BladePass(name="blade_pass", at=at, order_output=float(whole), amplitude=_START)
            amplitude = _START * line_factor(case, case.model.rig + part, place)
            yield from _blades(
                case,
                replace(part, amplitude=amplitude),
                place=left_line(case, whole * turns),  # half as many blades are another hypothesis
                loosens=() if place in left else SLOW_TORQUE,  # which lines of the rig's own cannot tell from it
            )


def _blades(
    case: Case, part: mechanisms.BladePass, *, place: Place | None, loosens: tuple[str, ...]
) -> Iterator[Candidate]:
    knobs = (Knob(part.name, "amplitude", 1.0),)
    opposing = Candidate(mechanism="blade_pass", parts=(part,), knobs=knobs, place=place, loosens=loosens)
    yield opposing
    if any(features.turning is not None for features in case.seen):
        yield replace(opposing, parts=(replace(part, one_way=True),), variant="one_way")


def _instead_of_own_lines(case: Case, turns: float) -> Iterator[int]:
    """Yield numbers of blades that the rig's own lines stand in for, or that runs show which turn back."""
    found = [_whole(place.at / turns, turns) for place in bent_lines(case)]
    known = case.seen[0].places
    found += [pulses_both_ways(run, known, turns=turns)[0] for run in case.runs]
    yield from (whole for whole in dict.fromkeys(found) if whole)


def _whole(blades: float, turns: float) -> int:
    """Return the whole number of blades that an order stands at, else 0."""
    whole = round(blades)
    return whole if 1 <= whole <= _MOST_BLADES and abs(blades - whole) * turns <= WHOLE_ORDER else 0
