"""A study says which of its drives have a speed loop near instability, and simulates none that is unstable."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi

import pytest

from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.recordings.run import Run
from torquerig.reporting.study.answers import narrow_loops
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Coupling, Motor, SpeedController
from torquerig.scenario.overrides import overridden
from torquerig.simulation.twin.linear_twin import twin_of
from torquerig.study.candidates import candidates, scenario_of
from torquerig.study.definition import Study, open_study
from torquerig.study.loop_margin import loop_margin
from torquerig.study.preflight import check_study, margin_of
from torquerig.study.results import DriveResult, StudyRuns

RATE = 5000.0


@cache
def catalog() -> Catalog:
    return load_catalog(shipped_folder())


def study_of(name: str, *settings: str) -> Study:
    return open_study(overridden(read_document(shipped_scenarios() / name), settings), catalog())


def two_masses(crossover: float) -> Rig:
    """A mode at 112 Hz, damped by 1 %, and a loop that crosses as the rule of a study says."""
    motor = Motor(name="motor", inertia=1e-3, torque_limit=100.0)
    bar = Coupling(name="bar", after="motor", stiffness=400.0, damping=0.011, inertia=1e-4)
    wheel = Body(name="wheel", after="bar", inertia=3.9e-3)
    loop = SpeedController(name="loop", kp=2 * pi * crossover * 5e-3, ki=1.0)
    return Rig((motor, bar, wheel, loop), Run(speed=20.0), measured="bar")


@pytest.mark.parametrize("crossover", [5.0, 40.0, 150.0])
def test_the_margin_is_that_of_python_control(crossover: float) -> None:
    rig = two_masses(crossover)
    found = loop_margin(rig, motor="motor", crossover=crossover, rate=RATE)
    assert found is not None
    (theirs,) = twin_of(rig, rate=RATE).margins()
    assert found.stable == theirs.stable
    assert found.modulus == pytest.approx(theirs.modulus_margin, rel=1e-2)
    assert found.mode == pytest.approx(112.5, rel=1e-2)  # sqrt(k (1/J1 + 1/J2)) / 2 pi


def test_a_loop_near_instability_is_a_doubt_and_one_beyond_it_a_fault() -> None:
    calm, near, beyond = (
        loop_margin(two_masses(crossover), motor="motor", crossover=crossover, rate=1000.0)
        for crossover in (5.0, 60.0, 200.0)
    )
    assert calm is not None
    assert near is not None
    assert beyond is not None
    assert calm.doubt == calm.fault == near.fault == beyond.doubt == ""
    assert "lower study: speed_loop: crossover" in near.doubt
    assert "crossover 60 Hz, first torsional mode 113 Hz, 1000 Hz sample rate" in near.doubt
    assert beyond.fault.startswith("its speed loop is unstable (crossover 200 Hz")


def test_the_shipped_studies_are_tuned_with_margin_but_for_fast_motors_at_1_kHz() -> None:
    """A light servo motor at 10 Hz crossover and 1 kHz: its own loop gain at half the sample rate is nearly 1."""
    study = study_of("shaft_line_design.yaml")
    doubts = {}
    for one in candidates(study):
        margin = margin_of(scenario_of(one, study, seed=study.settings.seed), study)
        assert margin is not None
        assert not margin.fault
        doubts[one.motor] = margin.doubt
    assert [motor for motor, doubt in doubts.items() if doubt] == ["HDS6A-0104A", "ESM06X-401-302"]


def test_an_unstable_present_drive_is_refused_before_the_first_run() -> None:
    study = study_of("shaft_line_design.yaml", "study.speed_loop.crossover=150 Hz")
    scenarios = {one: scenario_of(one, study, seed=1) for one in candidates(study)}
    with pytest.raises(InputError, match=r"is out of reach \(its speed loop is unstable \(crossover 150 Hz"):
        check_study(study, scenarios)


def test_the_report_lists_the_doubt_of_a_drive(runs_of_a_doubt: StudyRuns) -> None:
    (sentence,) = narrow_loops(runs_of_a_doubt)
    assert sentence.startswith("HDS6A-0104A: its speed loop amplifies disturbances by up to")


@pytest.fixture
def runs_of_a_doubt() -> StudyRuns:
    from torquerig.metrics.figure import Figure

    study = study_of("shaft_line_design.yaml")
    calm, doubtful = (
        next(one for one in candidates(study) if one.motor == motor) for motor in ("ESM013B-152-304", "HDS6A-0104A")
    )
    made = [
        DriveResult(
            candidate=one, margins={}, out_of_reach="", motor_speed=1.0, torque_limit=1.0, kp=1.0, assumed={},
            shares=None, disturbance=Figure(), chains={},
        )
        for one in (calm, doubtful)
    ]  # fmt: skip
    drives = tuple(replace(drive, loop=margin_of(scenario_of(drive.candidate, study, seed=1), study)) for drive in made)
    return StudyRuns(
        study=study, drives=drives, mean_load=1.0, occupancy_percent=5.0, particle_size=5e-4, output_speed=1.0
    )
