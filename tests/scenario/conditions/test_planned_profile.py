"""Profiles with points of their own in a scenario: speeds of the motor, occupancies as torques, faults."""

from __future__ import annotations

from functools import cache
from math import pi

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document, read_document
from torquerig.errors import InputError
from torquerig.scenario.model import Scenario
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

# ruff: noqa: E501 (a table: one case in a row)
RPM = pi / 30
CYCLE = (
    "operating_point.duty_cycle={segments: [{duration: 0.4 s, output_speed: 300 rpm, ramp: true, occupancy: 0 %},"
    " {duration: 0.4 s, motor_speed: 1500 rpm, occupancy: 21 %},"
    " {duration: 0.2 s, output_speed: 300 rpm, load_torque: 2 N*m}]}"
)


@cache
def catalog():
    return load_catalog(shipped_folder())


def wear_rig(*settings: str) -> Scenario:
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), settings)
    return read_scenario(document, catalog(), seed=1)


def test_speeds_are_the_motors_and_occupancies_are_loads():
    run = wear_rig("profile=duty_cycle", CYCLE).rig.run
    course = run.speed_profile()
    assert run.speed == pytest.approx(1500 * RPM)
    assert course.speed(np.array([0.1, 0.5, 0.9]), top=0.0, duration=1.0) == pytest.approx([1500 * RPM] * 3)
    assert course.load(np.array([0.1, 0.5, 0.9])) == pytest.approx([0.05, 3.8, 2.0])


def test_a_simulated_cycle_has_the_loads_of_its_segments():
    """At 300 rpm of output the viscous drag of 0.010 N m s/rad is 0.314 N m beside the load."""
    made = wear_rig("profile=duty_cycle", CYCLE, "load.hit_rms=0", "load.slow_rms=0")
    recording = simulate(made.rig, duration=2.0, seed=1, settling=0.5)
    load = recording.channel("true_load_Nm").values
    rate = recording.sample_rate
    means = [load[int(a * rate) : int(b * rate)].mean() for a, b in ((0.2, 0.38), (1.6, 1.78), (1.9, 1.98))]
    # the speed swings by some percent behind a step of the load, and the drag with it
    assert np.array(means) - 0.314 == pytest.approx([0.05, 3.8, 2.0], abs=0.02)
    assert recording.run.profile == "duty_cycle"


def test_a_table_is_found_beside_its_scenario(tmp_path):
    text = (
        (shipped_scenarios() / "wear_rig.yaml")
        .read_text()
        .replace("profile: steady", "profile: csv\n  csv: {file: c.csv}")
    )
    (tmp_path / "c.csv").write_text("time_s,output_speed_rpm,torque_Nm\n0,0,1\n2,100,3\n")
    made = read_scenario(parse_document(text, tmp_path / "rig.yaml"), catalog(), seed=1)
    assert made.rig.run.speed == pytest.approx(500 * RPM)
    assert made.rig.run.speed_profile().length == 2
    (tmp_path / "c.csv").write_text("time_s,output_speed_rpm,torque_Nm\n0,0,1\n2,,3\n")
    with pytest.raises(InputError, match=r"c\.csv:3: the profile has a gap: output_speed_rpm is no number"):
        read_scenario(parse_document(text, tmp_path / "rig.yaml"), catalog(), seed=1)


FAULTS = {
    "no segments": ("profile=duty_cycle", "operating_point.duty_cycle=null"),
    "empty": ("profile=duty_cycle", "operating_point.duty_cycle={segments: []}"),
    "missing one": ("operating_point.duty_cycle={segments: [{duration: 1 s, motor_speed: 5 rpm}, null]}",),
    "no speed": ("operating_point.duty_cycle={segments: [{duration: 1 s}]}",),
    "two speeds": ("operating_point.duty_cycle={segments: [{duration: 1 s, motor_speed: 5 rpm, output_speed: 1 rpm}]}",),
    "two loads": (
        "operating_point.duty_cycle={segments: [{duration: 1 s, motor_speed: 5 rpm, occupancy: 5 %, load_torque: 1 N*m}]}",
    ),
    "no time": ("operating_point.duty_cycle={segments: [{duration: 0 s, motor_speed: 5 rpm}]}",),
    "no file": ("profile=csv",),
    "unknown occupancy": (
        "profile=duty_cycle", "operating_point.duty_cycle={segments: [{duration: 1 s, motor_speed: 5 rpm, occupancy: 50 %}]}",
    ),
}  # fmt: skip
TOLD = {
    "no segments": "needs its segments; add duty_cycle",
    "empty": "needs a list of segments",
    "missing one": r"segment 2 is missing \(it is None\)",
    "no speed": "a segment needs its speed, once; write output_speed or motor_speed",
    "two speeds": "a segment needs its speed, once",
    "two loads": "both load_torque and occupancy are stated",
    "no time": "length of the segment must be more than 0",
    "no file": "needs its table; add csv",
    "unknown occupancy": r"occupancy 50 % is outside 0\.\.21 %",
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_broken_profile_is_refused_with_its_place(name):
    with pytest.raises(InputError, match=rf"wear_rig\.yaml.*{TOLD[name]}|--set .*{TOLD[name]}"):
        wear_rig(*FAULTS[name])
