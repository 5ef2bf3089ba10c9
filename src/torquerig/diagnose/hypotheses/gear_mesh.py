"""A mesh of teeth: lines at a whole order of a gear's output, their harmonics, and side lines of the planets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case, left_line, line_factor
from torquerig.diagnose.fitting.knobs import Knob
from torquerig.diagnose.looking.places import SAME_ORDER, order
from torquerig.rig.parts import BeltStage, Gear
from torquerig.scenario.kinematics import gears_to_sensor

_FEWEST_TEETH, _MOST_TEETH = 10, 300  # per turn of a gear's output
_STRONGEST = 5  # lines that are tried as a mesh
_HARMONICS = 4
_SMALL = 1e-6  # [rad]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a mesh for each of the strongest lines that could be a first or second tooth harmonic."""
    lines = [peak for peak in case.left if peak.place.domain == "order"][:_STRONGEST]
    tried: set[tuple[str, int]] = set()
    for gear in gears_to_sensor(case.nominal):
        for peak in lines:
            for harmonic in (1, 2):
                teeth = peak.place.at * abs(gear.ratio) / harmonic
                whole = round(teeth)
                near = abs(teeth - whole) < SAME_ORDER * abs(gear.ratio)
                if near and _FEWEST_TEETH <= whole <= _MOST_TEETH and (gear.name, whole) not in tried:
                    tried.add((gear.name, whole))
                    yield _mesh(case, gear, whole)


def _mesh(case: Case, gear: Gear | BeltStage, teeth: int) -> Candidate:
    turns = abs(gear.ratio)
    # a mesh whose first harmonic nobody sees pays for it all the same, or half the teeth would do as well
    seen = [1, *(h for h in range(2, _HARMONICS + 1) if left_line(case, h * teeth / turns))]
    planets = next((n for n in (3, 4, 5) if any(left_line(case, (teeth + s * n) / turns) for s in (1, -1))), None)
    part = mechanisms.GearMesh(
        name="gear_mesh",
        gear=gear.name,
        order_output=float(teeth),
        transmission_error=tuple(_SMALL for _ in range(max(seen))),
        planets=planets or 3,
        planet_modulation=0.1 if planets else 0.0,
    )
    sizes = list(part.transmission_error)
    for harmonic in seen:
        place = left_line(case, harmonic * teeth / turns) or order(harmonic * teeth / turns)
        sizes[harmonic - 1] *= line_factor(case, case.model.rig + part, place)
    knobs = [Knob(part.name, "transmission_error", 1.0, key=harmonic - 1) for harmonic in seen]
    knobs += [Knob(part.name, "planet_modulation", 1.0)] if planets else []
    part = replace(part, transmission_error=tuple(sizes))
    return Candidate(mechanism="gear_mesh", parts=(part,), knobs=tuple(knobs), place=left_line(case, teeth / turns))
