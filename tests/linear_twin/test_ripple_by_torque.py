"""Ripple in proportion to the motor's torque, when that torque is itself uneven: side lines against the simulator."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import BladePass, CommutationRipple, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.scenario.model import Scenario
from torquerig.simulation.simulator import simulate

SPEED = 500 * pi / 30
ORDER, SLOW = 42.0, 1.0


@pytest.mark.parametrize("blades", [False, True])
def test_what_the_speed_loop_answers_makes_side_lines(blades: bool, wear_rig: Scenario) -> None:
    """A line of order 1 that moves the speed by little, and no load: side lines of d |t| / 2."""
    bare = wear_rig.rig
    for ripple in bare.parts_of(TorqueRipple):
        own = {SLOW: 0.02} if ripple.name == "motor.mechanical" and not blades else {}
        bare = bare.changed(replace(ripple, amplitudes=own))
    if blades:  # five on the wear part, which turns a fifth as fast
        bare = bare + BladePass(name="blades", order_output=5.0 * SLOW, amplitude=0.1)
    rig = bare + CommutationRipple(name="ripple", order_motor=ORDER, depth=0.4)
    rig = rig.at(Run(**{**vars(rig.run), "speed": SPEED, "occupancy_percent": 0.0, "profile": "steady"}))
    made = simulate(rig, duration=6.0, seed=2, sample_rate=25_000.0)
    angle = made.channels["true_motor_angle_rad"].values
    torque = made.channels["true_sensor_torque_Nm"].values
    window = np.hanning(torque.size)
    twin = Twin(rig)
    for side in (ORDER - SLOW, ORDER + SLOW):
        seen = 2 * abs(np.sum(torque * window * np.exp(-1j * side * angle))) / window.sum()
        (line,) = (line for line in twin.lines() if abs(line.order - side) < 1e-9 and not line.by_load)
        told = line.amplitude * float(np.abs(line.transfer(np.array([side * SPEED / (2 * pi)])))[0])
        assert seen == pytest.approx(told, rel=0.1), side
