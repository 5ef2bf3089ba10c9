"""Every encoder of a rig has a channel of its own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import torquerig as tr
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.rig.parts import MotorEncoder
from torquerig.simulation.simulator import simulate


def test_a_second_encoder_adds_a_channel() -> None:
    made = tr.read_scenario(shipped_scenarios() / "wear_rig.yaml")
    fine = made.rig.parts_of(MotorEncoder)[0]
    rig = made.rig + replace(fine, name="coarse", counts_per_rev=fine.counts_per_rev // 16)
    recording = simulate(rig, duration=0.1, seed=1, settling=0.0)
    counts = {name: one.values for name, one in recording.channels.items() if one.quantity == "motor_angle"}
    assert {"encoder_count", "coarse_count"} <= counts.keys()
    assert np.array_equal(np.floor(counts["encoder_count"] / 16), counts["coarse_count"])
