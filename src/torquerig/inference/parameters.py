"""Parameters of the nominal model with their priors: what the scenario leaves open, and what it never states."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt

import numpy as np

from torquerig.diagnosis.fitting.knobs import Knob, nuisance_knobs
from torquerig.inference.measured_run import MeasuredRun
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

_RECTANGULAR = sqrt(3)  # half-width over standard deviation of a tolerance (JCGM 100:2008, 4.3.7)
_ZERO = 0.05  # of the largest torque: standard deviation of a zero of which nothing is stated
_SCALE = 0.002  # [1] standard deviation of a sensitivity of which nothing is stated


def parameters(scenario: Scenario, rig: Rig, runs: Sequence[MeasuredRun]) -> tuple[Knob, ...]:
    """Return the parameters of the nominal model: numbers of the parts, and scale and zero of the sensor."""
    occupancies = [run.run.occupancy_percent or 0.0 for run in runs]
    knobs = nuisance_knobs(rig, scenario.uncertainties, occupancies=occupancies)
    known = {knob.name for knob in knobs}
    return (*knobs, *(knob for knob in _of_sensor(rig, runs) if knob.name not in known))


def _of_sensor(rig: Rig, runs: Sequence[MeasuredRun]) -> tuple[Knob, ...]:
    sensor = rig.part(rig.measured)
    if not sensor.is_sensor or not hasattr(sensor, "zero"):
        return ()
    tolerance = getattr(sensor, "gain_tolerance", 0.0)
    within = getattr(sensor, "zero_tolerance", None)
    largest = max(float(np.abs(run.torque).max(initial=0.0)) for run in runs)
    zero = _ZERO * largest if within is None else within / _RECTANGULAR
    return (
        Knob(sensor.name, "scale", tolerance / _RECTANGULAR or _SCALE),
        *([Knob(sensor.name, "zero", zero, factor=False)] if zero and not getattr(sensor, "tare", False) else []),
    )
