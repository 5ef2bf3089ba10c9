"""The commutation ripple that a motor's known lines leave out, against a simulation that has it."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.mechanisms import CommutationRipple
from torquerig.metrics.omitted_ripple import omitted_six_pulse
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

CATALOG = load_catalog(shipped_folder())


def test_twin_predicts_what_a_simulated_ripple_adds() -> None:
    rig = read_scenario(read_document(shipped_scenarios() / "wear_rig.yaml"), CATALOG, seed=1).rig
    depth = 0.10
    rough = rig + CommutationRipple(name="six_step", order_motor=42, depth=depth)
    plain, with_ripple = (simulate(each, duration=2.0, seed=1) for each in (rig, rough))
    sensed = "true_sensor_torque_Nm"
    added = float(np.std(with_ripple.channels[sensed].values - plain.channels[sensed].values))
    torque = float(plain.channels["true_motor_torque_Nm"].values.mean())
    figure = omitted_six_pulse(rig, CATALOG.motor("bldc-12n14p"), motor_torque=torque)
    assert figure.low is not None
    # the interval of the class is 5..25 %; the drive's torque swings by a tenth, the twin takes its mean
    assert figure.low * depth / 0.05 == pytest.approx(added, rel=0.03)
    assert figure.high == pytest.approx(5 * figure.low)


def test_motors_whose_class_lines_are_simulated_leave_nothing_out() -> None:
    rig = read_scenario(read_document(shipped_scenarios() / "wear_rig.yaml"), CATALOG, seed=1).rig
    assert omitted_six_pulse(rig, CATALOG.motor("HDS6A-0104A"), motor_torque=0.3).unknown
