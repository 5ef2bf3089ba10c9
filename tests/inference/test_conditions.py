"""Conditions that a sidecar does not state come from the scenario or the samples, and the diagnosis says so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig.inference.engine import prepared
from torquerig.inference.readings.conditions import with_measured_course, with_occupancy
from torquerig.recordings.recording import Channel


@pytest.fixture(scope="module")
def pump(tmp_path_factory):
    scenario = pump_scenario(tmp_path_factory.mktemp("pump"))
    return scenario, recorded(scenario)


def conditions(recording, **changed):
    return replace(recording, run=replace(recording.run, **changed))


def test_an_occupancy_that_is_not_stated_is_that_of_the_scenario(pump):
    scenario, (first, second) = pump
    rig = scenario.rig.at(replace(scenario.rig.run, occupancy_percent=40.0))
    runs = [conditions(first, occupancy_percent=None), conditions(second, occupancy_percent=10.0)]
    made, said = with_occupancy(runs, rig)
    assert [each.run.occupancy_percent for each in made] == [40.0, 10.0]
    assert [each[:50] for each in said] == ["run1.parquet: the sidecar states no occupancy. Tha"]


def test_a_rig_whose_load_depends_on_no_occupancy_needs_none(pump):
    scenario, (first, _) = pump
    rig = scenario.rig.without("load").at(replace(scenario.rig.run, occupancy_percent=40.0))
    made, said = with_occupancy([conditions(first, occupancy_percent=None)], rig)
    assert (made[0].run.occupancy_percent, said) == (None, ())


def with_speed(recording, rad_s):
    speed = Channel(values=rad_s, quantity="motor_speed", unit="rad/s")
    return recording.with_channel("speed", speed)


@pytest.mark.parametrize(("share", "profile"), [(0.03, "steady"), (0.9, "csv")])
def test_a_run_whose_measured_speed_changes_is_not_steady(pump, share, profile):
    scenario, (first, _) = pump
    speed = np.linspace(100.0 * (1 - share), 100.0, first.samples)
    made, said = with_measured_course([with_speed(first, speed)], scenario.rig)
    assert made[0].run.profile == profile
    assert len(said) == (profile == "csv")
    if said:
        course = made[0].run.speed_profile().speed(first.time(), top=100.0, duration=first.duration)
        assert np.abs(course - speed).max() < 1.0
        assert "the measured speed goes from" in said[0]


def test_a_drive_that_sways_about_its_set_point_is_steady(pump):
    scenario, (first, _) = pump
    speed = 100.0 + 20.0 * np.sin(2 * np.pi * 3.0 * first.time())
    made, said = with_measured_course([with_speed(first, speed)], scenario.rig)
    assert (made[0].run.profile, said) == ("steady", ())


def test_a_stated_course_stays(pump):
    scenario, (first, _) = pump
    ramp = conditions(with_speed(first, np.linspace(10.0, 100.0, first.samples)), profile="ramp")
    made, said = with_measured_course([ramp], scenario.rig)
    assert (made, said) == ([ramp], ())


def test_the_diagnosis_says_what_it_has_taken_from_elsewhere(pump):
    scenario, runs = pump
    at = replace(scenario, rig=scenario.rig.at(replace(scenario.rig.run, occupancy_percent=40.0)))
    found = prepared(at, [conditions(run, occupancy_percent=None) for run in runs])
    assert sum("states no occupancy" in each for each in found.remarks) == len(runs)
