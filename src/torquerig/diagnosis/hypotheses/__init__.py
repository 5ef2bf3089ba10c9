"""How each mechanism of the library would explain what a model leaves: one file per class of the contract.

A proposal holds parts of the library with starting values; the simulator's own classes do the rest. A class whose
mechanism is not in the library proposes nothing.

Lines of the shafts
    gear_mesh  commutation_ripple  cogging  blade_pass
Lines of fixed frequency
    mains_interference  pwm_aliasing
The shafts and the sensor
    torsional_mode  sensor_bandwidth  bearing_defect
The slow torque
    quadratic_drag  stribeck_friction  sensor_drift
Beside the linear twin
    backlash
Beside the classes
    fixed_lines  left lines that keep their frequency      reasons  why a class was set aside
    beside_steps  what an effect of the slow torque pays where the mean steps
    motor_orders  where slots and poles put cogging
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from importlib import import_module

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.rig.assembly import Part, Rig

Propose = Callable[[Case], Iterator[Candidate]]

CLASSES = {
    "gear_mesh": "GearMesh",
    "commutation_ripple": "CommutationRipple",
    "cogging": "Cogging",
    "blade_pass": "BladePass",
    "mains_interference": "MainsInterference",
    "pwm_aliasing": "PwmAliasing",
    "torsional_mode": "TorsionalMode",
    "sensor_bandwidth": "SensorBandwidth",
    "bearing_defect": "BearingDefect",
    "quadratic_drag": "QuadraticDrag",
    "stribeck_friction": "StribeckFriction",
    "sensor_drift": "SensorDrift",
}


def proposers(case: Case, *, among: Collection[str] | None = None) -> tuple[Propose, ...]:
    """Return, for every mechanism of the library that the case lacks, what proposes its ways to complete the model.

    Of those ``among`` some alone, where they are said. A mechanism that is long to seek has several in its ``WAYS``, so
    that they are sought side by side.
    """
    lacking = [name for name, of in CLASSES.items() if hasattr(mechanisms, of) and not case.has(name)]
    lacking = [name for name in lacking if among is None or name in among]
    rooms = [import_module(f"{__name__}.{name}") for name in lacking]
    return tuple(way for room in rooms for way in getattr(room, "WAYS", (room.propose,)))


def is_possible(candidate: Candidate, rig: Rig) -> bool:
    """Whether the numbers that a fit gave a candidate in ``rig`` are such as can be, and as its runs can show."""
    fitted = [rig.part(part.name) for part in candidate.parts]
    too_much = (getattr(part, field, 0.0) >= most for field, most in candidate.below.items() for part in fitted)
    too_little = (
        getattr(part, field, math.inf) <= least for field, least in candidate.above.items() for part in fitted
    )
    if any(too_much) or any(too_little):
        return False
    return _asked("possible", candidate, fitted)


def is_likely(candidate: Candidate, rig: Rig) -> bool:
    """Whether they are such as rigs have: what is not gives way to another name for as much."""
    return _asked("likely", candidate, [rig.part(part.name) for part in candidate.parts])


def _asked(what: str, candidate: Candidate, fitted: Sequence[Part]) -> bool:
    """Return what the candidate's mechanism says of its fitted parts; True where it says nothing."""
    if candidate.mechanism not in CLASSES:
        return True
    asked = getattr(import_module(f"{__name__}.{candidate.mechanism}"), what, None)
    return asked is None or all(asked(part) for part in fitted)


def told_loosely(candidate: Candidate) -> Mapping[str, float]:
    """Return the fields of a candidate's parts that fits tell loosely, so that chance may put them beyond what can be.

    A mechanism has them in its ``TOLD_LOOSELY``: -1 for what chance may put too high, 1 for what it may put too low.
    """
    if candidate.mechanism not in CLASSES:
        return {}
    return getattr(import_module(f"{__name__}.{candidate.mechanism}"), "TOLD_LOOSELY", {})
