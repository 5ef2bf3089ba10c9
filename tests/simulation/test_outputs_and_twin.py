"""Probes anywhere on the rig, and the closed loop against its linear response."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.mechanisms import TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, Probe, SpeedController
from torquerig.simulation.linear import spring_response
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate


def rig(*more: Probe, speed_rpm: float = 800.0) -> Rig:
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=5.0),
            Gear(name="gear", after="motor", ratio=4.0, stiffness=9e3, damping=2.0, output_inertia=6e-4),
            Coupling(name="sensor", after="gear", stiffness=1100, damping=0.3, inertia=1e-4),
            Body(name="wheel", after="sensor", inertia=2e-3, viscous=0.02),
            SpeedController(name="controller", kp=0.05, ki=0.5),
            TorqueRipple(name="ripple", at="motor", group="cogging", amplitudes={6: 0.02}),
            *more,
        ),
        Run(speed=speed_rpm * pi / 30),
        measured="sensor",
    )


def test_probes_read_any_spring_and_shaft() -> None:
    probes = (
        Probe(name="gear_torque", quantity="torque", at="gear"),
        Probe(name="motor_speed", quantity="speed", at="motor"),
        Probe(name="wheel_angle", quantity="angle", at="wheel"),
    )
    made = simulate(rig(*probes), duration=0.3, seed=2)
    assert np.array_equal(made.channels["motor_speed_rad_s"].values, made.channels["true_motor_speed_rad_s"].values)
    # on average the gear carries what the sensor carries, for nothing else takes torque between them
    carried = made.channels["gear_torque_Nm"].values.mean()
    assert carried == pytest.approx(made.channels["true_sensor_torque_Nm"].values.mean(), rel=2e-3)
    speed = np.gradient(made.channels["wheel_angle_rad"].values) * made.sample_rate
    assert speed.mean() == pytest.approx(800 * pi / 30 / 4, rel=1e-3)
    assert not made.channels["gear_torque_Nm"].truth
    assert set(made.without_truth().to_frame()) == {
        "torque_V",
        "gear_torque_Nm",
        "motor_speed_rad_s",
        "wheel_angle_rad",
    }


def test_a_torque_probe_needs_a_spring() -> None:
    with pytest.raises(InputError, match="'wheel' has no spring"):
        simulate(rig(Probe(name="p", quantity="torque", at="wheel")), duration=0.1, seed=1)


def test_closed_speed_loop_shuts_out_slow_ripple_as_the_handbook_says() -> None:
    """Inside the loop's bandwidth motor disturbances are multiplied by 1/(1 + L): measured against the twin."""
    slow = rig(speed_rpm=200.0)
    made = simulate(slow, duration=3.0, seed=4)
    order = 6 * made.channels["true_motor_angle_rad"].values
    columns = np.column_stack([np.ones(order.size), np.cos(order), np.sin(order)])
    fit = np.linalg.lstsq(columns, made.channels["true_sensor_torque_Nm"].values, rcond=None)[0]
    frequency = np.array([6 * 200 / 60])
    response = {
        closed: abs(spring_response(lower(slow, 4), "sensor", frequency, speed_loop=closed)["motor"][0]) * 0.02
        for closed in (True, False)
    }
    assert np.hypot(fit[1], fit[2]) == pytest.approx(response[True], rel=0.01)
    assert response[True] < 0.8 * response[False]  # so that the loop is seen at all
