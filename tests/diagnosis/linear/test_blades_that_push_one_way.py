"""Blades whose pulses push one way: the same mean either way, where those that oppose the motion change its sign."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.linear.winding import wound_torque
from torquerig.linear_twin.quasi_static import quasi_static
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import BladePass, TorqueRipple
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.simulation.linear_path import simulate_linear
from torquerig.simulation.simulator import simulate

AMPLITUDE = 0.4


def rig_with(scenario: Scenario, *, one_way: bool, backward: bool = False) -> Rig:
    rig = scenario.rig
    for ripple in rig.parts_of(TorqueRipple):
        rig = rig.changed(replace(ripple, amplitudes={}))
    run = replace(rig.run, speed=-60.0 if backward else 60.0, occupancy_percent=0.0)
    return (rig + BladePass(name="blades", order_output=5.0, amplitude=AMPLITUDE, one_way=one_way)).at(run)


@pytest.mark.long
@pytest.mark.parametrize(("one_way", "expected"), [(False, 0.0), (True, 2 * AMPLITUDE / 4)])
def test_both_directions_together_read_twice_the_mean(one_way: bool, expected: float, wear_rig: Scenario) -> None:
    """Friction, drag and load change their sign with the motion: A/4 stays, for the simulators and the twin."""
    both = [rig_with(wear_rig, one_way=one_way, backward=backward) for backward in (False, True)]
    for simulated in (simulate, simulate_linear):
        read = [simulated(rig, duration=4.0, seed=3, sample_rate=5000.0).torque().mean() for rig in both]
        assert sum(read) == pytest.approx(expected, abs=0.01)
    twin, speed, still = Twin(both[0]), np.array([60.0, -60.0]), np.zeros(2)
    assert quasi_static(twin, speed=speed, acceleration=still).sensor.sum() == pytest.approx(expected, abs=1e-9)
    course = np.repeat(speed, 4000)
    wound = wound_torque(twin, speed=course, acceleration=np.zeros(course.size), step=1e-3, start=0.0).torque
    assert wound[3999] + wound[-1] == pytest.approx(expected, abs=1e-9)


def test_forwards_both_are_the_same(wear_rig: Scenario) -> None:
    one, other = (
        simulate(rig_with(wear_rig, one_way=one_way), duration=1.0, seed=3, sample_rate=5000.0).torque()
        for one_way in (True, False)
    )
    assert np.abs(one - other).max() < 1e-9
