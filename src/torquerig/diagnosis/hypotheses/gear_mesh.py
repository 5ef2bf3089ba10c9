"""A mesh of teeth: lines at a whole order of a gear's output, their harmonics, and side lines of the planets."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import log

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case, left_line, line_factor
from torquerig.diagnosis.hypotheses.motor_orders import STRONG, cogging_orders
from torquerig.inference.knobs import Knob
from torquerig.inference.places import SAME_ORDER, WHOLE_ORDER, order
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Motor
from torquerig.rig.parts.gear_stage import GearStage, gear_stages
from torquerig.scenario.kinematics import turns_to

_FEWEST_TEETH, _MOST_TEETH = 10, 300  # per turn of a gear's output, or of its input where that is the slower one
# few small gears have more teeth: odds of one in twenty, and of one in four hundred, twice their logarithms
_UNCOMMON = {150: 6.0, 200: 12.0}
_STRONGEST = 5  # lines that are tried as a mesh
_HARMONICS, _FURTHEST = 4, 6  # that smeared ones may hide, and that are looked for where they show
_SMALL = 1e-6  # [rad]
_OF_THE_FIRST = 0.1  # a harmonic that shows in bands or by its side lines alone starts there
_FIRST = 0.1  # of the largest: an error of teeth is largest once per tooth, and half the teeth would do without


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a mesh for each of the strongest lines that could be a first, second or third tooth harmonic.

    Where the rig's own lines hide the first two, the third is the first to be left.
    """
    lines = [peak for peak in case.left if peak.place.domain == "order"][:_STRONGEST]
    tried: set[tuple[str, int]] = set()
    for peak in lines:
        for gear, teeth in _meshes(case.nominal, peak.place.at):
            if (gear.name, teeth) in tried:
                continue
            tried.add((gear.name, teeth))
            yield _mesh(case, gear, teeth)
            if peak.excess > STRONG and not all(run.angle_measured for run in case.runs if run.steady):
                yield _mesh(case, gear, teeth, smeared=True)


def _meshes(rig: Rig, at: float) -> list[tuple[GearStage, int]]:
    """Return which gears, with how many teeth, may have a harmonic at a motor order ``at``.

    Where one of them states its teeth, and so many, it is that one's.
    """
    found = []
    for gear in (one for one in gear_stages(rig) if not one.in_a_line):
        turns = _turns_of_teeth(rig, gear)
        for harmonic in (1, 2, 3):
            whole = round(at * turns / harmonic)
            near = abs(at * turns / harmonic - whole) < WHOLE_ORDER * turns
            if near and _FEWEST_TEETH <= whole <= _MOST_TEETH:
                found.append((gear, whole))
    return [(gear, teeth) for gear, teeth in found if _states(gear, teeth)] or found


def _states(gear: GearStage, teeth: int) -> bool:
    return bool(gear.teeth) and abs(gear.teeth[-1].mesh_order_out - teeth * _slower(gear)) < SAME_ORDER


def _slower(gear: GearStage) -> float:
    """Return the turns of the side on which teeth are counted per turn of the output: 1 but where it drives up."""
    return min(abs(gear.ratio), 1.0)


def _turns_of_teeth(rig: Rig, gear: GearStage) -> float:
    """Return the turns of the motor per turn of the side on which teeth are counted."""
    return turns_to(rig, gear.name) / _slower(gear)


def _mesh(case: Case, gear: GearStage, teeth: int, *, smeared: bool = False) -> Candidate:
    """Return the mesh with the harmonics that show; with all of them where ``smeared`` ones may stand in bands."""
    turns = _turns_of_teeth(case.nominal, gear)
    tooth = [h * teeth for h in range(1, _HARMONICS + 1)]  # the first may be too small for lines beside it
    planets = next((n for n in (3, 4, 5) if any(_beside(case, at, n, turns) for at in tooth)), None)
    # a mesh whose first harmonic nobody sees pays for it all the same, or half the teeth would do as well
    further = range(2, _FURTHEST + 1)
    seen = [1, *(h for h in further if (smeared and h <= _HARMONICS) or _shows(case, h * teeth, planets, turns))]
    part = mechanisms.GearMesh(
        name="gear_mesh",
        gear=gear.name,
        order_output=teeth * _slower(gear),
        transmission_error=tuple(_SMALL for _ in range(max(seen))),
        planets=planets or 3,
        planet_modulation=0.1 if planets else 0.0,
    )
    sizes = list(part.transmission_error)
    for harmonic in seen:
        place = left_line(case, harmonic * teeth / turns) or order(harmonic * teeth / turns)
        shown = harmonic == 1 or left_line(case, harmonic * teeth / turns) is not None
        factor = line_factor(case, case.model.rig + part, place)
        sizes[harmonic - 1] = _SMALL * factor if shown else _OF_THE_FIRST * sizes[0]
    knobs = [Knob(part.name, "transmission_error", 1.0, key=harmonic - 1) for harmonic in seen]
    knobs += [Knob(part.name, "planet_modulation", 1.0)] if planets else []
    part = replace(part, transmission_error=tuple(sizes))
    price = max((price for most, price in _UNCOMMON.items() if teeth > most), default=0.0)
    price += _price_of_a_coincidence(case, turns, teeth)
    first = left_line(case, teeth / turns)
    return Candidate(mechanism="gear_mesh", parts=(part,), knobs=tuple(knobs), place=first, price=price)


def _price_of_a_coincidence(case: Case, turns: float, teeth: int) -> float:
    """Return what teeth pay whose lowest line that shows stands where a motor's slots and poles put cogging.

    Twice the logarithm of the odds that a number of teeth, any of the common ones, does so by chance.
    """
    orders = [at for motor in case.nominal.parts_of(Motor) for at in cogging_orders(motor)]
    shown = next((h for h in range(1, _FURTHEST + 1) if left_line(case, h * teeth / turns) is not None), 1)
    if not _stands_on(shown * teeth / turns, orders):
        return 0.0
    common = range(_FEWEST_TEETH, min(_UNCOMMON) + 1)
    return 2.0 * log(len(common) / max(sum(_stands_on(shown * each / turns, orders) for each in common), 1))


def _stands_on(at: float, orders: Sequence[int]) -> bool:
    return any(abs(at - each) < SAME_ORDER for each in orders)


def _beside(case: Case, order_output: int, planets: int, turns: float) -> bool:
    """Whether a left line stands where planets would put one beside a tooth harmonic."""
    return any(left_line(case, (order_output + side * planets) / turns) for side in (1, -1))


def _shows(case: Case, order_output: int, planets: int | None, turns: float) -> bool:
    """Whether a tooth harmonic is left itself or, where that hides, by a line beside it."""
    return bool(left_line(case, order_output / turns)) or (
        planets is not None and _beside(case, order_output, planets, turns)
    )


def possible(part: Part) -> bool:
    """Whether fitted sizes could be those of teeth, and not of twice as many."""
    sizes = part.transmission_error if isinstance(part, mechanisms.GearMesh) else ()
    return bool(sizes) and abs(sizes[0]) > _FIRST * max(abs(size) for size in sizes)
