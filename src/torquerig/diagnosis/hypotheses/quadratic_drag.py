"""Drag that grows with the square of the speed: the level bends upwards where viscous friction is straight."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from torquerig import mechanisms
from torquerig.diagnosis.case import SLOW_TORQUE, Candidate, Case
from torquerig.diagnosis.linear.loaded_part import loaded_part
from torquerig.diagnosis.looking.features import Features
from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Rig

_STARTS = (1e-5, 1e-4, 1e-3)  # [N m s^2/rad^2]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield that of a few sizes on the loaded part which fits best, where the runs differ in speed.

    It is sought beside the model as fitted, whose viscous friction may stand in for it, and beside the nominal one.
    """
    at = loaded_part(case.nominal)
    speeds = [speed for features in case.seen for speed in _speeds(features)]
    if at is None or not speeds or min(speeds) > 0.9 * max(speeds):
        return
    sizes = [mechanisms.QuadraticDrag(name="quadratic_drag", at=at, coefficient=start) for start in _STARTS]
    for part in dict.fromkeys(_best(case, sizes, rig) for rig in (case.model.rig, case.nominal_with_accepted())):
        knobs = (Knob(part.name, "coefficient", 1.5),)
        yield Candidate(mechanism="quadratic_drag", parts=(part,), knobs=knobs, loosens=SLOW_TORQUE)


def _best(case: Case, sizes: Sequence[mechanisms.QuadraticDrag], rig: Rig) -> mechanisms.QuadraticDrag:
    return min(sizes, key=lambda one: case.misfit_of(rig + one))


def _speeds(features: Features) -> list[float]:
    """Return at which speeds of the motor a run shows its slow torque [rad/s]."""
    shown = features.speed.mean(axis=1) if features.turning is None else features.turning.speed
    return [abs(float(speed)) for speed in shown]
