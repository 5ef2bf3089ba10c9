"""A rig in the phases of a run: those of its lines are found, and unused samples have no influence."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.inference.motor_angle.smoothed_speed import speed_of
from torquerig.inference.prediction.line_phases import Samples, with_measured_phases
from torquerig.mechanisms import TorqueRipple
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.simulation.simulator import simulate

RATE = 5000.0  # [Hz]
AT = 1.1  # [rad] at the source


def phases(rig: Rig) -> dict[tuple[str, float], float]:
    return {(each.name, at): phase for each in rig.parts_of(TorqueRipple) for at, phase in each.phases.items()}


def test_the_phase_of_a_line_is_found_in_the_used_samples(known_rig: Scenario) -> None:
    ripple = max(known_rig.rig.parts_of(TorqueRipple), key=lambda each: max(each.amplitudes.values()))
    strongest = max(ripple.amplitudes, key=lambda at: ripple.amplitudes[at])
    rig = known_rig.rig.changed(replace(ripple, phases={**ripple.phases, strongest: AT}))
    made = simulate(rig, duration=6.0, seed=3, sample_rate=RATE)
    angle, torque = made.channels["true_motor_angle_rad"].values, made.torque()
    used = np.arange(torque.size) < 4 * RATE
    samples = Samples(run=rig.run, rate=RATE, torque=torque, angle=angle, speed=speed_of(angle, RATE), used=used)
    found = phases(with_measured_phases(rig, samples))
    # of the noise: a hundredth of the line, twice the transfer between two points of its grid
    assert np.angle(np.exp(1j * (found[ripple.name, strongest] - AT))) == pytest.approx(0.0, abs=0.1)
    other = np.where(used, torque, np.random.default_rng(1).standard_normal(torque.size))
    assert phases(with_measured_phases(rig, replace(samples, torque=other))) == pytest.approx(found)
