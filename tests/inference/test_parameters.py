"""The parameters of a nominal model: amplitudes of lines are among them, whatever part states them."""

from __future__ import annotations

import pytest

from tests.inference.drawn_runs import drawn_run, steady
from tests.inference.pump_bench import pump_scenario
from torquerig import mechanisms
from torquerig.inference.parameters import amplitudes, parameters

STATED = [
    (mechanisms.BeltLines(name="belt", belt_error=(1e-4, 0.0), tooth_error=1e-5), ["belt_error.0", "tooth_error"]),
    (mechanisms.GearMesh(name="mesh", order_output=51, transmission_error=(1e-4, 2e-5)),
     ["transmission_error.0", "transmission_error.1"]),
    (mechanisms.MainsInterference(name="hum", frequency=50.0, amplitudes=(0.02,)), ["amplitudes.0"]),
    (mechanisms.CommutationRipple(name="steps", order_motor=24, depth=0.02), ["depth"]),
]  # fmt: skip


@pytest.fixture(scope="module")
def scenario(tmp_path_factory):
    return pump_scenario(tmp_path_factory.mktemp("pump"))


@pytest.mark.parametrize(("part", "fields"), STATED, ids=[part.name for part, _ in STATED])
def test_every_amplitude_that_is_not_zero_is_a_parameter(scenario, part, fields):
    found = [knob for knob in amplitudes(scenario.rig + part) if knob.part == part.name]
    assert [knob.name.removeprefix(f"{part.name}.") for knob in found] == fields
    assert all(knob.factor and knob.spread > 0.1 for knob in found)


def test_a_stated_spread_goes_before_the_assumed_one(scenario):
    (knob,) = [
        one
        for one in parameters(scenario, scenario.rig, (drawn_run(1, speed=steady(1200.0)),))
        if one.name == "lines.amplitudes.1"
    ]
    assert knob.spread == 0.2


def test_other_numbers_are_not_freed(scenario):
    names = {knob.name for knob in amplitudes(scenario.rig)}
    assert names == {"lines.amplitudes.1"}
