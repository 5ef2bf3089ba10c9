"""Speeds that no drive makes: a wrong sample rate, wrong counts or wrong set-points."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from tests.inference.pump_bench import pump_scenario
from torquerig.inference.knobs import Knob
from torquerig.inference.readings.clock import rescaled, set_point, speed_factor
from torquerig.inference.readings.induction_slip import slipped
from torquerig.rig.parts.induction_drive import InductionDrive


@pytest.fixture(scope="module")
def rig(tmp_path_factory):
    return pump_scenario(tmp_path_factory.mktemp("pump")).rig


@pytest.fixture(scope="module")
def on_mains(rig):
    """Return the pump on an induction motor of 1430 rpm at 4 N m."""
    parts = tuple(part for part in rig.parts if part.name != "controller")
    drive = InductionDrive(
        name="supply", motor="motor", pole_pairs=2, rated_torque=4.0, rated_speed=149.8, breakdown_torque=10.0
    )
    return replace(rig, parts=(*parts, drive))


def read(factor, *, stated=1000.0, knobs=()):
    """Return a reading of two runs whose real speed is ``factor`` times the stated one."""
    runs = tuple(
        replace(drawn_run(seed, speed=steady(stated * factor, duration=3.0)), speed_factor=factor) for seed in (1, 2)
    )
    return SimpleNamespace(runs=runs, fit=SimpleNamespace(knobs=knobs))


@pytest.mark.parametrize("factor", [1.024, 0.9, 2.0, 0.5])
def test_a_speed_beyond_the_error_of_the_set_point_is_a_fault(rig, factor):
    found = speed_factor(read(factor), rig, set_point_error=0.005)
    assert found.value == pytest.approx(factor)
    faults = [fault for _, fault in rescaled(read(factor).runs, found)] + [set_point(found)]
    for fault, true in zip(faults, (2000.0 / factor, factor), strict=True):
        low, high = fault.interval
        assert low < true < high


def test_what_a_drive_may_be_off_by_is_none(rig):
    assert speed_factor(read(1.012), rig, set_point_error=0.005) is None
    assert speed_factor(read(1.024), rig, set_point_error=0.01) is None


def test_a_slip_of_the_pen_is_exact(rig):
    assert speed_factor(read(2.004), rig, set_point_error=0.005).value == 2.0


def test_an_induction_motor_slips_by_its_load(on_mains):
    run = drawn_run(1, speed=steady(1500.0)).run
    share, unsure = slipped(on_mains, run, ())
    torque = 2.0 + 0.003 * run.speed * share  # load and viscous drag of the pump
    # Kloss: T / Tb = 2 x / (1 + x^2), x the slip over that of breakdown
    slips = np.array([1 - share, 1 - 149.8 / (50 * np.pi)])
    over = 10.0 / np.array([torque, 4.0])
    assert slips[0] / slips[1] == pytest.approx(np.divide(*(over - np.sqrt(over**2 - 1))), rel=0.02)
    assert 0.1 * slips[0] < unsure < 0.2 * slips[0]


def test_an_uncertain_load_makes_the_slip_uncertain(on_mains):
    run = drawn_run(1, speed=steady(1500.0)).run
    load = Knob("load", "mean_by_occupancy_percent", 0.5, key=0)
    assert slipped(on_mains, run, (load,))[1] > slipped(on_mains, run, ())[1]


def test_slip_is_no_fault_and_what_exceeds_it_is(on_mains):
    share, _ = slipped(on_mains, drawn_run(1, speed=steady(1500.0)).run, ())
    assert speed_factor(read(share, stated=1500.0), on_mains, set_point_error=0.005) is None
    found = speed_factor(read(0.9 * share, stated=1500.0), on_mains, set_point_error=0.005)
    assert found.value == pytest.approx(0.9, abs=0.005)


def test_a_ramp_has_the_slip_in_its_factor_already(on_mains):
    share, _ = slipped(on_mains, drawn_run(1, speed=steady(1500.0)).run, ())
    assert share < 0.98
    turning = read(1.0, stated=1500.0)
    runs = [
        replace(run, recording=replace(run.recording, run=replace(run.run, profile="ramp"))) for run in turning.runs
    ]
    assert speed_factor(SimpleNamespace(runs=runs, fit=turning.fit), on_mains, set_point_error=0.005) is None
