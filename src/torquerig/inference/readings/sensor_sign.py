"""The other sense of the sensor: where all mean torques have the other sign."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import log

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.readings.clock import counts_of
from torquerig.inference.readings.reading import CLEARLY, Reading, SetupFault, gain_of, sketched_like
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_OF_RANGE = 0.5  # of the largest mean torque: standard deviation of a zero that nobody set
_ALIKE = log(20.0)  # [nats] a zero that is less far behind is not excluded
_SIGN_MATTERS = 3  # levels at least, with a mean that exceeds their scatter


def other_sign(reading: Reading, rig: Rig) -> Reading:
    """Return the reading with the torque of the other sign where all mean torques have it."""
    measured = np.concatenate([seen.level for seen in reading.data.seen])
    expected = np.concatenate([each.level for each in reading.fit.expected]) - _moved_zero(reading, rig)
    tells = measured.size >= _SIGN_MATTERS and abs(expected.mean()) > expected.std() / np.sqrt(expected.size)
    if not tells or float(measured @ expected) >= 0:
        return reading
    runs = tuple(replace(run, torque=-run.torque) for run in reading.runs)
    by_name = {run.name: run for run in runs}
    seen = tuple(_reversed(one, by_name[one.run.name]) for one in reading.data.seen)
    data, fit = replace(reading.data, seen=seen), reading.fit
    again = sketched_like(fit, data)
    if gain_of(again, fit) <= CLEARLY:
        return reading
    ahead = again.log_evidence - _with_another_zero(reading, rig, measured, expected)
    if ahead < 0:
        return reading
    fault = _fault(reading.runs, rig.measured, alike=ahead < _ALIKE)
    return Reading(runs, data, again, (fault, *reading.faults))


def _fault(runs: Sequence[MeasuredRun], sensor: str, *, alike: bool) -> SetupFault:
    """Return which sense is the other one: the encoder's where it turns against all set-points, else the sensor's."""
    if all(run.speed_factor < 0 for run in runs):
        counts = counts_of(runs[0]) or 1.0
        return SetupFault(
            kind="counts_per_rev", of="encoder", stated=counts, estimated=-counts, unit="1/rev",
            equivalent_to=("sensor_sign",),
            explanation="The encoder counts backwards: its angle turns against the set-points, and the torque agrees "
            "with the set-points. A set-point without its sign, or a reversed sensor, would look the same.",
        )  # fmt: skip
    return SetupFault(
        kind="sensor_sign", of=sensor, stated=1.0, estimated=-1.0, unit="1",
        equivalent_to=("sensor_zero",) if alike else (),
        explanation=f"The sensor {sensor} reads with the other sign than the scenario states: it is mounted the "
        "other way round, or its cable is.",
    )  # fmt: skip


def _moved_zero(reading: Reading, rig: Rig) -> float:
    """Return by how much the fit has moved the zero [N m]: one that is not known follows a turned sign."""
    fitted, stated = (getattr(each.part(rig.measured), "zero", 0.0) for each in (reading.fit.fitted_rig, rig))
    return float(fitted - stated)


def _with_another_zero(reading: Reading, rig: Rig, measured: Floats, expected: Floats) -> float:
    """Return the evidence [nats] with a zero that nobody set: it turns the sign of all mean torques too."""
    fit = reading.fit
    columns = [at for at, knob in enumerate(fit.knobs) if (knob.part, knob.field) == (rig.measured, "zero")]
    if not columns:
        return -np.inf
    wide = _OF_RANGE * float(np.abs(measured).max())
    zero = float((measured - expected).mean())
    knob = columns[0], replace(fit.knobs[columns[0]], spread=wide), zero / wide
    return sketched_like(fit, reading.data, knob=knob).log_evidence


def _reversed(seen: RunFeatures, run: MeasuredRun) -> RunFeatures:
    return replace(seen, run=run, level=-seen.level)
