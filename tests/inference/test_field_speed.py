"""The speed of an induction motor in runs whose angle nobody measured and whose lines do not show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario, simulated
from torquerig.inference.motor_angle.shaft_angle import shaft_angles
from torquerig.linear_twin.field_speed import share_of_field
from torquerig.mechanisms import TorqueRipple
from torquerig.recordings.recording import Channel
from torquerig.rig.parts.induction_drive import InductionDrive

FIELDS = (1500.0, 500.0)  # [rpm]


@pytest.fixture(scope="module")
def on_mains(tmp_path_factory):
    """Return the pump on an induction motor, with drag that makes its slip depend on the speed."""
    made = pump_scenario(tmp_path_factory.mktemp("mains"))
    drive = InductionDrive(
        name="supply", motor="motor", pole_pairs=2, rated_torque=4.0, rated_speed=149.8, breakdown_torque=10.0
    )
    parts = [part for part in made.rig.parts if part.name != "controller" and not isinstance(part, TorqueRipple)]
    pump = replace(made.rig.part("pump"), viscous=0.02)
    parts = [pump if part.name == "pump" else part for part in parts]
    return replace(made, rig=replace(made.rig, parts=(*parts, drive)))


def test_a_run_without_an_angle_turns_at_the_slip_of_its_load(on_mains):
    first, second = simulated(on_mains, speeds=FIELDS)
    true = [np.diff(run.channels["true_motor_angle_rad"].values).mean() * run.sample_rate for run in (first, second)]
    encoder = Channel(values=first.channels["true_motor_angle_rad"].values, quantity="motor_angle", unit="rad")
    runs = [first.without_truth().with_channel("encoder", encoder), second.without_truth()]
    angles = shaft_angles(runs, on_mains.rig)
    speeds = [np.diff(angle.values).mean() * run.sample_rate for angle, run in zip(angles, runs, strict=True)]
    assert speeds == pytest.approx(true, rel=3e-3)
    assert [angle.factor for angle in angles] == pytest.approx(
        [one / (rpm * np.pi / 30) for one, rpm in zip(true, FIELDS, strict=True)], rel=3e-3
    )
    assert angles[0].factor - angles[1].factor > 0.003  # wander is 0.001


def test_only_an_induction_motor_slips(on_mains, tmp_path):
    run = replace(on_mains.rig.run, speed=150.0)
    assert share_of_field(on_mains.rig, run) < 0.99
    assert share_of_field(pump_scenario(tmp_path).rig, run) == 1.0
    assert share_of_field(on_mains.rig, replace(run, speed=0.0)) == 1.0
