"""Drag with the square of the speed, a zero of the sensor that drifts, mains interference, a further inertia."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.inference.addition import DECADE
from torquerig.inference.knobs import Knob
from torquerig.inference.motion.fitted_model import Fit, effort_scale
from torquerig.inference.motion.hypotheses.shown import carrier, top_speed
from torquerig.inference.motion.hypothesis import Hypothesis
from torquerig.inference.motion.imposed_run import BAND, ImposedRun
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import Inertia

Floats = NDArray[np.float64]

_SIZE = 0.1  # of the rms effort: median of the prior of a size that nobody knows, a decade wide
_SETTLING = (0.1, 0.3, 1.0)  # of the longest run: time constants of a zero that settles
_BRANCHES = (0.05, 0.2, 0.6)  # of the compared band: frequencies of a further inertia on a spring
_MAINS = (50.0, 60.0)  # [Hz]


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield what the model does not have."""
    present = {each.name for each in fit.model.additions} | {part.kind for part in fit.model.nominal.parts}
    for family in (_drag, _drift, _mains, _branch):
        for each in family(fit):
            if each.name not in present:
                yield each


def _drag(fit: Fit) -> Iterator[Hypothesis]:
    name = carrier(fit.model.nominal)
    if name is not None:
        part = mechanisms.QuadraticDrag(
            name="quadratic_drag", at=name, coefficient=_SIZE * effort_scale(fit.runs) / top_speed(fit) ** 2
        )
        yield Hypothesis(name=part.name, mechanism=part.name, label=f"drag with the square of the speed at {name}",
                         parts=(part,), knobs=(Knob(part.name, "coefficient", DECADE),), start=(0.0,))  # fmt: skip


def _drift(fit: Fit) -> Iterator[Hypothesis]:
    longest = max(float(run.time[-1]) for run in fit.runs)
    for tau in (None, *(share * longest for share in _SETTLING)):

        def columns(run: ImposedRun, tau: float | None = tau) -> Floats:
            return (run.time / longest if tau is None else 1 - np.exp(-run.time / tau))[:, None]

        def written(sizes: Floats, tau: float | None = tau) -> tuple[Part, ...]:
            return (mechanisms.SensorDrift(name="sensor_drift", span=float(sizes[0]), time_constant=tau),)

        yield Hypothesis(
            name="sensor_drift", mechanism="sensor_drift", variant="linear" if tau is None else "exponential",
            label="a drift of the sensor's zero" + ("" if tau is None else f" with a time constant of {tau:.3g} s"),
            columns=columns, scale=_SIZE * effort_scale(fit.runs), written=written, axis="time",
        )  # fmt: skip


def _mains(fit: Fit) -> Iterator[Hypothesis]:
    for hum in _MAINS:
        if hum < BAND * min(run.rate for run in fit.runs):

            def columns(run: ImposedRun, hum: float = hum) -> Floats:
                return np.column_stack([np.cos(2 * np.pi * hum * run.time), np.sin(2 * np.pi * hum * run.time)])

            yield Hypothesis(
                name="mains_interference", mechanism="mains_interference", label=f"mains interference at {hum:g} Hz",
                columns=columns, scale=_SIZE * effort_scale(fit.runs), local=True, axis="Hz", at=hum,
            )  # fmt: skip


def _branch(fit: Fit) -> Iterator[Hypothesis]:
    at = carrier(fit.model.nominal)
    if at is not None:
        for share in _BRANCHES:
            branch = mechanisms.TorsionalMode(
                name="torsional_mode", after=at, frequency=share * BAND * min(run.rate for run in fit.runs),
                inertia=0.1 * _inertia(fit.rig, at), damping_ratio=0.05,
            )  # fmt: skip
            knobs = tuple(Knob(branch.name, field, spread) for field, spread in
                          (("frequency", 0.3), ("inertia", 1.0), ("damping_ratio", 1.0)))  # fmt: skip
            yield Hypothesis(name=branch.name, mechanism=branch.name, label=f"a further inertia on a spring at {at}",
                             parts=(branch,), knobs=knobs, start=(0.0, 0.0, 0.0))  # fmt: skip


def _inertia(rig: Rig, at: str) -> float:
    return sum(term.inertia for term in rig.terms() if isinstance(term, Inertia) and term.node == rig.node(at))
