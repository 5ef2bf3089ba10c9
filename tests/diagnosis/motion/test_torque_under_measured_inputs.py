"""A torque sensor behind a measured motion, with a measured load: each recording drives its own simulation."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

import torquerig as tr
from torquerig.catalog.reading import Catalog
from torquerig.diagnosis.any_rig import diagnosed
from torquerig.diagnosis.motion.moved import moved_runs
from torquerig.diagnosis.motion.predicted import predicted
from torquerig.document import parse_document
from torquerig.recordings.recording import Channel, Recording
from torquerig.rig.imposed_part import imposed_part
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.recorded.compared_channel import as_measured
from torquerig.scenario.recorded.input_checks import as_driven

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


def scenario(last: str, *, point: str = "{}", viscous: float = 0.01) -> Scenario:
    text = SHAFT.format(point=point, viscous=viscous) + last
    return read_scenario(parse_document(text, Path("shaft.yaml")), Catalog(), seed=1)


def recorded(rpm: float, seed: int, seconds: float) -> Recording:
    """A run of the shaft under a speed loop and its own load, as a rig records it: no truth, no origin."""
    time = np.arange(round(1000 * seconds)) / 1000
    waves = np.random.default_rng(seed).standard_normal(time.size)
    load = 2 + 0.3 * np.sin(2 * pi * 3 * time) + np.convolve(waves, np.ones(20) / 20, "same")
    brake = Channel(values=load, quantity="torque", unit="N*m", role="input", of="rotor")
    given = Recording(sample_rate=1000.0, channels={"brake_Nm": brake})
    made = tr.simulate(scenario(LOOP, point=f"{{motor_speed: {rpm} rpm}}"), inputs=given, seed=seed)
    speed = Channel(values=made.channels["true_motor_speed_rad_s"].values * 30 / pi, quantity="motor_speed",
                    unit="rpm", si_per_unit=pi / 30, role="input", of="motor")  # fmt: skip
    return replace(made.without_truth().with_channel("speed_rpm", speed), origin={}, name=f"run{seed}.csv")


@pytest.fixture(scope="module")
def runs() -> list[Recording]:
    return [recorded(rpm, seed, 4.0) for seed, rpm in enumerate((600.0, 900.0), start=1)]


def test_every_recording_is_predicted_by_its_own_inputs(runs: list[Recording]) -> None:
    """Within the noise of 5 mN m, below a tenth of the rate; the other recording's load is far off."""
    made = scenario(TURNED)
    assert imposed_part(made.rig) is not None
    driven = as_driven(made, as_measured(runs, made.rig))
    for run, other in zip(moved_runs(driven, made.rig), reversed(driven), strict=True):
        error = predicted(made.rig, run) - run.effort
        assert np.std(error[run.seen]) < 0.02
        swapped = replace(run, recording=replace(run.recording, run=other.run))
        assert np.std((predicted(made.rig, swapped) - run.effort)[run.seen]) > 0.1


@pytest.mark.long
def test_the_diagnosis_says_what_it_compares_and_misses_nothing(runs: list[Recording]) -> None:
    outcome = diagnosed(scenario(TURNED), runs, seed=0)
    assert outcome.diagnosis.verdict == "adequate"
    assert "run1.csv: compared: outer_V of outer; context: inner_V of inner" in outcome.diagnosis.remarks
    assert outcome.completed.places == ("outer", "inner")


@pytest.mark.long
def test_drag_that_the_scenario_lacks_is_seen(runs: list[Recording]) -> None:
    outcome = diagnosed(scenario(TURNED, viscous=0.0), runs[:1], seed=0)
    assert outcome.diagnosis.verdict != "adequate"
