"""The reading with and without each part that a diagnosis added."""

from __future__ import annotations

import pytest

import torquerig as tr
from torquerig.studio.diagnosing.each_effect import each_effect


@pytest.mark.long
def test_the_change_is_that_of_the_effect_alone():
    scenario = tr.read_scenario("wear_rig.yaml")
    hum = tr.mechanisms.MainsInterference(name="hum", amplitudes=(0.3,), phases=(0.0,))
    small = tr.mechanisms.MainsInterference(name="small", frequency=60.0, amplitudes=(0.03,), phases=(0.0,))
    recording = tr.simulate(scenario, duration=1.0, truth=False)
    rows = each_effect((scenario + hum + small).rig, scenario.rig, [recording], seed=0)
    assert [row[:2] for row in rows] == [("hum", "mains interference"), ("small", "mains interference")]
    assert float(rows[0][2].split()[0]) == pytest.approx(0.3 / 2**0.5, rel=0.02)  # the converter rounds
    assert float(rows[1][2].split()[0]) == pytest.approx(0.03 / 2**0.5, rel=0.05)
    assert each_effect(scenario.rig, scenario.rig, [recording], seed=0) == ()
