"""The shipped rigs of other designs: every command runs on each, at its own rate, in its own units."""

from __future__ import annotations

from functools import cache
from math import pi
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.document import read_document
from torquerig.rig.steady import steady_torque
from torquerig.scenario.kinematics import kinematics_of, ratio_text, torque_gain
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.sections import output_moves_in_a_line
from torquerig.study.definition import Study, open_study
from torquerig.study.operating_points import points_of
from torquerig.study.run_study import run_study
from torquerig.study.scoring import decide

RATES = {"belt_servo_axis": 10e3, "linear_axis": 5e3}
UNITS = {"linear_axis": "N"}


@cache
def made(name: str) -> Scenario:
    return read_scenario(read_document(shipped_scenarios() / f"{name}.yaml"), load_catalog(shipped_folder()), seed=1)


def study(name: str) -> Study:
    return open_study(read_document(shipped_scenarios() / f"{name}.yaml"), load_catalog(shipped_folder()))


def said(*arguments: object, capsys: pytest.CaptureFixture[str]) -> str:
    main([str(one) for one in arguments])
    return capsys.readouterr().out


@pytest.mark.parametrize("name", RATES)
def test_every_command_reads_the_rig(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scenario, recording = shipped_scenarios() / f"{name}.yaml", tmp_path / "run.parquet"
    said("simulate", scenario, "--duration", "2 s", "--truth", "--out", recording, capsys=capsys)
    assert f"at {RATES[name]:.0f} Hz, 2 s" in said("info", recording, capsys=capsys)
    filtered = said("filter", recording, "--chain", "order_lines", "--scenario", scenario, capsys=capsys)
    assert f"error to true load {UNITS.get(name, 'N*m')}" in filtered
    assert "amplitude" in said("ordermap", recording, "--scenario", scenario, capsys=capsys)
    assert "mode 1" in said("modes", scenario, capsys=capsys)


@pytest.mark.parametrize("name", RATES)
def test_the_motor_carries_its_load(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    scenario = shipped_scenarios() / f"{name}.yaml"
    assert "No limit is exceeded" in said("size", scenario, capsys=capsys)
    assert "Safe" in said("duty", scenario, capsys=capsys)


def test_the_belt_axis_by_hand() -> None:
    rig = made("belt_servo_axis").rig
    brake = 0.09 + 0.45 * (14.9 - 0.09)
    assert rig.run.speed == pytest.approx(600 * pi / 30)
    assert torque_gain(rig) == pytest.approx(2 * 0.97)
    drag = 1e-3 * 300 * pi / 30
    motor = rig.part("motor")
    lost = motor.coulomb + motor.viscous * 600 * pi / 30
    assert steady_torque(rig, "motor") == pytest.approx((brake + drag) / 1.94 + lost, rel=1e-6)
    causes = {source.name for shaft in kinematics_of(rig).shafts for source in shaft.sources}
    assert {"belt mesh", "belt"} <= causes


def test_the_linear_axis_by_hand() -> None:
    rig = made("linear_axis").rig
    assert ratio_text(rig) == "10 mm per turn"
    force = 400 + 30 + 15 + 0.05 * 140
    motor = rig.part("motor")
    lost = motor.coulomb + motor.viscous * 300 * pi / 30
    assert steady_torque(rig, "motor") == pytest.approx(force * 0.01 / (2 * pi * 0.9) + lost, rel=1e-6)


@pytest.mark.parametrize("name", RATES)
def test_a_study_knows_its_units_and_points(name: str) -> None:
    opened = study(name)
    assert output_moves_in_a_line(opened.document.data) == (name in UNITS)
    assert opened.effort_unit == UNITS.get(name, "N*m")
    assert points_of(opened) == ()


@pytest.mark.long
@pytest.mark.parametrize("name", RATES)
def test_each_study_comes_to_a_verdict(name: str) -> None:
    runs = run_study(study(name))
    decided = decide(runs)
    present = next(drive for drive in runs.drives if drive.candidate.motor == runs.study.settings.present.motor)
    assert present.recording is not None
    assert present.recording.sample_rate == RATES[name]
    assert {one.unit for drive in runs.drives for chain in drive.chains.values() for one in [chain.truth_error]} == {
        UNITS.get(name, "N*m")
    }
    assert decided.ranked()
