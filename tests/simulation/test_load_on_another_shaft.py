"""A load behind a gear or a drum is compared with the reading on the measured shaft, in its unit."""

from __future__ import annotations

from functools import cache
from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.metrics.sizing.load_fidelity import reading_per_load
from torquerig.metrics.truth_error import difference, true_load
from torquerig.rig.load_lever import load_lever
from torquerig.scenario.load_response import load_response
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

RIG = """
operating_point: {output_speed: OUTPUT, load: {occupancy: 50 %}}
measured: flange
rig:
  motor: {kind: motor, inertia: 2 kg*cm^2, torque_limit: 50 N*m, model: m}
  flange: {kind: torque_sensor, stiffness: 60 kN*m/rad, damping: 0.4 N*m*s/rad, inertia: 3 kg*cm^2,
           sensitivity: 0.1 V/(N*m), bandwidth: 900 Hz, noise_rms: 0 V}
STAGE
  load: {kind: particle_load, at: worn, mean_by_occupancy_percent: {50: MEAN}, hit_rms: 0, slow_rms: 0.05,
         smoothing: SMOOTHING}
  speed_controller: {kind: speed_controller, motor: motor, kp: 0.2 N*m*s/rad, ki: 2 N*m/rad}
"""
GEAR = """
  gear: {kind: gear, ratio: RATIO, efficiency: 1, stiffness: 5 kN*m/rad, damping: 5 N*m*s/rad,
         output_inertia: 1 kg*cm^2}
  worn: {kind: body, inertia: 4 kg*cm^2}
"""
DRUM = """
  drum: {kind: linear_drive, lead: 314 mm, stiffness: 2 kN/mm, damping: 3 kN*s/m}
  worn: {kind: slide, mass: 2 kg}
"""


@cache
def scenario(stage: str, output: str, mean: str, smoothing: str) -> Scenario:
    text = RIG.replace("STAGE\n", stage.lstrip("\n")).replace("OUTPUT", output).replace("MEAN", mean)
    return read_scenario(parse_document(text.replace("SMOOTHING", smoothing), Path("rig.yaml")), Catalog(), seed=1)


RIGS = {
    "gear": ((GEAR.replace("RATIO", "2.5"), "200 rpm", "5 N*m", "0.02 rad/s"), 1 / 2.5, 5.0),
    "reversing": ((GEAR.replace("RATIO", "-2.5"), "200 rpm", "5 N*m", "0.02 rad/s"), -1 / 2.5, 5.0),
    "drum": ((DRUM, "60 rpm", "400 N", "1 mm/s"), 0.314 / (2 * pi), 400.0),
}


@pytest.mark.parametrize("name", RIGS)
def test_the_true_load_is_that_of_the_measured_shaft(name: str) -> None:
    stated, lever, mean = RIGS[name]
    made = scenario(*stated)
    assert load_lever(made.rig, made.rig.node("worn")) == pytest.approx(lever)
    recording = simulate(made.rig, duration=2.0, seed=1, settling=1.0, sample_rate=2000.0)
    load = true_load(recording)
    assert load is not None
    assert abs(load.mean()) == pytest.approx(mean * abs(lever), rel=0.1)
    assert recording.torque().mean() == pytest.approx(load.mean(), rel=0.02)
    error = difference(recording, recording)
    assert np.sqrt(np.mean(error**2)) < 0.05 * abs(load.mean())


@pytest.mark.parametrize("name", RIGS)
def test_slow_load_is_whole_in_the_reading_of_the_twin(name: str) -> None:
    made = scenario(*RIGS[name][0])
    assert abs(reading_per_load(made.rig, np.array([0.01]), closed=True)[0]) == pytest.approx(1, abs=0.02)
    response = load_response(made.rig, rate=2000.0)
    assert abs(response.values[0]) == pytest.approx(1, abs=0.02)
