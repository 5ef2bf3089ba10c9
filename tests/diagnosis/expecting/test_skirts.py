"""How a random load shakes the motor's angle: the closed form beside the simulator's own angle."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import welch

from torquerig.diagnosis.expecting.skirts import _straying
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import TorqueRipple
from torquerig.scenario.model import Scenario
from torquerig.simulation.simulator import simulate

RATE = 1000.0


@pytest.mark.parametrize("occupancy", [5.0, 15.0])
def test_the_angle_strays_as_the_load_over_the_impedance_says(occupancy: float, wear_rig: Scenario) -> None:
    """From 3 to 30 Hz within a third, the first mode near 130 Hz being far; 12 s hold 40 values a band."""
    rig = wear_rig.rig
    for ripple in rig.parts_of(TorqueRipple):
        rig = rig.changed(replace(ripple, amplitudes={}))
    rig = rig.at(replace(rig.run, occupancy_percent=occupancy, profile="steady"))
    made = simulate(rig, duration=24.0, seed=3, sample_rate=5000.0)
    angle = made.channels["true_motor_angle_rad"].values[::5]
    strayed = angle - np.polyval(np.polyfit(np.arange(angle.size), angle, 1), np.arange(angle.size))
    frequency, density = welch(strayed, RATE, nperseg=2000)
    wanted = _straying(Twin(rig), np.maximum(frequency, 0.1))
    for low, high in ((3.0, 8.0), (8.0, 30.0)):
        inside = (frequency > low) & (frequency < high)
        assert density[inside].mean() == pytest.approx(wanted[inside].mean(), rel=0.35)
