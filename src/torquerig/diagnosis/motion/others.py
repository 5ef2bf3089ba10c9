"""The rivals of friction: drag with the square of the speed, a zero that moves, a branch that swings along."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.friction import STOOD_IN, carrier
from torquerig.diagnosis.motion.moved import BAND, Moved
from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Inertia

Floats = NDArray[np.float64]

_CLASSES = {
    "quadratic_drag": "QuadraticDrag",
    "sensor_drift": "SensorDrift",
    "torsional_mode": "TorsionalMode",
}
_WARMING = (0.1, 0.3, 1.0)  # of the longest run, time constants of a zero that settles
_BRANCHES = (0.05, 0.2, 0.6)  # of the compared band's edge
_SHARE, _DAMPING = 0.1, 0.05
_TRACE = 1e-4


def propose(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    """Yield drag, drifts along a straight line and of three time constants, and branches of three frequencies."""
    at = carrier(model.rig)
    present = {part.kind for part in model.rig.parts}
    present |= {kind for kind, name in _CLASSES.items() if not hasattr(mechanisms, name)}
    size = float(np.sqrt(np.mean(np.concatenate(model.of(runs)) ** 2)))
    if at is not None and "quadratic_drag" not in present:
        found = _slope(model, runs, [run.speed * np.abs(run.speed) for run in runs])
        quick = max(float(np.abs(run.speed).max()) for run in runs)
        drag = mechanisms.QuadraticDrag(name="quadratic_drag", at=at, coefficient=max(found, _TRACE * size / quick**2))
        yield Candidate(mechanism="quadratic_drag", parts=(drag,), knobs=(Knob(drag.name, "coefficient", 1.0),),
                        loosens=STOOD_IN)  # fmt: skip
    if "sensor_drift" not in present:
        found = _slope(model, runs, [run.recording.time() / run.recording.duration for run in runs])
        drift = mechanisms.SensorDrift(name="sensor_drift", span=found)
        zero = Knob(drift.name, "span", size, factor=False)
        yield Candidate(mechanism="sensor_drift", parts=(drift,), variant="linear", knobs=(zero,))
        longest = max(run.recording.duration for run in runs)
        for share in _WARMING:
            tau = share * longest
            found = _slope(model, runs, [1 - np.exp(-run.recording.time() / tau) for run in runs])
            drift = mechanisms.SensorDrift(name="sensor_drift", span=found, time_constant=tau)
            yield Candidate(mechanism="sensor_drift", parts=(drift,), variant="exponential",
                            knobs=(zero, Knob(drift.name, "time_constant", 1.0)))  # fmt: skip
    if at is not None and "torsional_mode" not in present:
        for share in _BRANCHES:
            branch = mechanisms.TorsionalMode(
                name="torsional_mode", after=at, frequency=share * BAND * min(run.rate for run in runs),
                inertia=_SHARE * _inertia(model.rig, at), damping_ratio=_DAMPING,
            )  # fmt: skip
            fields = (("frequency", 0.3), ("inertia", 1.0), ("damping_ratio", 1.0))
            knobs = tuple(Knob(branch.name, field, spread) for field, spread in fields)
            yield Candidate(mechanism="torsional_mode", parts=(branch,), knobs=knobs)


def _slope(model: FittedMotion, runs: Sequence[Moved], against: Sequence[Floats]) -> float:
    column = np.concatenate([each[run.seen] for each, run in zip(against, runs, strict=True)])
    left = np.concatenate(model.of(runs))
    return float(np.linalg.lstsq(np.column_stack([column, np.ones(column.size)]), left, rcond=None)[0][0])


def _inertia(rig: Rig, at: str) -> float:
    node = rig.node(at)
    return sum(term.inertia for term in rig.terms() if isinstance(term, Inertia) and term.node == node)
