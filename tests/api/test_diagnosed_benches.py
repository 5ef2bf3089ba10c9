"""Several measured places: which one is compared is stated, with a speed loop and along a measured motion."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

import torquerig as tr
from tests.inference.pump_bench import SCENARIO
from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.recordings.recording import Channel, Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

SHAFT = """
operating_point: {point}
recording: {{sample_rate: 1 kHz}}
measured: [outer, inner]
rig:
  motor: {{kind: motor, inertia: 15 kg*cm^2, torque_limit: 50 N*m}}
  inner: {{kind: torque_sensor, stiffness: 3 kN*m/rad, damping: 0.5 N*m*s/rad, inertia: 1 kg*cm^2, bandwidth: 200 Hz,
          noise_rms: 5 mV}}
  flywheel: {{kind: body, inertia: 40 kg*cm^2}}
  outer: {{kind: torque_sensor, stiffness: 3 kN*m/rad, damping: 0.5 N*m*s/rad, inertia: 1 kg*cm^2, bandwidth: 200 Hz,
          noise_rms: 5 mV}}
  rotor: {{kind: body, inertia: 20 kg*cm^2, viscous: {viscous} N*m*s/rad}}
  load: {{kind: replayed_torque, at: rotor, from: channel torque, factor: -1}}
"""
LOOP = "  loop: {kind: speed_controller, motor: motor, kp: 0.3 N*m*s/rad, ki: 3 N*m/rad}\n"
TURNED = "  turned: {kind: imposed_motion, at: motor, from: channel motor_speed}\n"

pytestmark = pytest.mark.long


def shaft(last: str, *, point: str = "{}", viscous: float = 0.01) -> Scenario:
    text = SHAFT.format(point=point, viscous=viscous) + last
    return read_scenario(parse_document(text, Path("shaft.yaml")), Catalog(), seed=1)


def recorded(rpm: float, seed: int, seconds: float) -> Recording:
    """A run of the shaft under a speed loop and a measured load, as a rig records it: no truth, no origin."""
    time = np.arange(round(1000 * seconds)) / 1000
    waves = np.random.default_rng(seed).standard_normal(time.size)
    load = 2 + 0.3 * np.sin(2 * pi * 3 * time) + np.convolve(waves, np.ones(20) / 20, "same")
    brake = Channel(values=load, quantity="torque", unit="N*m", role="input", of="rotor")
    given = Recording(sample_rate=1000.0, channels={"brake_Nm": brake})
    made = tr.simulate(shaft(LOOP, point=f"{{motor_speed: {rpm} rpm}}"), inputs=given, seed=seed)
    speed = Channel(values=made.channels["true_motor_speed_rad_s"].values * 30 / pi, quantity="motor_speed",
                    unit="rpm", si_per_unit=pi / 30, role="input", of="motor")  # fmt: skip
    return replace(made.without_truth().with_channel("speed_rpm", speed), origin={}, name=f"run{seed}.csv")


@pytest.fixture(scope="module")
def runs() -> list[Recording]:
    return [recorded(rpm, seed, 4.0) for seed, rpm in enumerate((600.0, 900.0), start=1)]


def test_along_a_measured_motion_the_first_place_is_compared_under_the_measured_load(runs: list[Recording]) -> None:
    answer = tr.diagnose(shaft(TURNED), runs)
    assert answer.verdict == "adequate"
    assert "run1.csv: compared: outer_V of outer; context: inner_V of inner" in answer.diagnosed.data["remarks"]
    assert answer.diagnosed.data["fit"]["after"]["heldout_misfit"] < 0.03  # noise of 5 mN m, of some 2 N m


def test_drag_that_the_scenario_lacks_is_seen(runs: list[Recording]) -> None:
    assert tr.diagnose(shaft(TURNED, viscous=0.0), runs[:1]).verdict != "adequate"


def test_with_a_speed_loop_the_first_place_is_compared() -> None:
    """The sensor behind the coupling reads another inertia than the one before it: the wrong one would not fit."""
    heavy = SCENARIO.replace("  shaft: {kind: coupling,", "  shaft: {kind: coupling, inertia: 0.001 kg*m^2,")
    sensors = heavy.replace("measured: sensor", "measured: [outer, sensor]").replace(
        "  pump:", "  outer: {kind: torque_sensor, stiffness: 3000 N*m/rad, damping: 0.5 N*m*s/rad, "
        "inertia: 0.003 kg*m^2, sensitivity: 0.5 V/(N*m), bandwidth: 500 Hz, noise_rms: 0.002 V}\n  pump:",
    )  # fmt: skip
    bench = read_scenario(parse_document(sensors, Path("bench.yaml")), Catalog(), seed=1)
    runs = []
    for seed, rpm in enumerate((800.0, 1200.0), start=1):
        at = bench.rig.at(replace(bench.rig.run, speed=rpm * pi / 30))
        made = simulate(at, duration=6.0, seed=seed, sample_rate=2000.0, wander=1e-3).without_truth()
        runs.append(replace(made, name=f"run{seed}.csv", run=at.run))
    answer = tr.diagnose(bench, runs)
    assert answer.verdict == "adequate"
    assert [
        one
        for one in answer.diagnosed.data["remarks"]
        if "compared: outer_V of outer; context: sensor_V of sensor" in one
    ]
    assert answer.diagnosed.data["setup"] == []
