"""The shipped rigs of other designs: every command runs on each, at its own rate, in its own units."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi
from pathlib import Path

import pytest
from scipy.signal import butter, sosfiltfilt

from torquerig.api.simulated import under_inputs
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.document import read_document
from torquerig.recordings.files import read_recording
from torquerig.reporting.diagnosis.run_check import run_check
from torquerig.rig.steady import steady_torque
from torquerig.scenario.kinematics import kinematics_of, ratio_text, torque_gain
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.sections import output_moves_in_a_line
from torquerig.simulation.simulator import simulate
from torquerig.study.definition import Study, open_study
from torquerig.study.operating_points import points_of
from torquerig.study.run_study import run_study
from torquerig.study.scoring import decide

RATES = {"belt_servo_axis": 10e3, "linear_axis": 5e3, "spur_gearbox_mixer": 5e3, "shaft_line_design": 1e3}
UNITS = {"linear_axis": "N"}
SECONDS = ("belt_servo_axis", "spur_gearbox_mixer")  # what their commands take, each
SHORT_AND_LONG = [pytest.param(name, marks=pytest.mark.long if name in SECONDS else ()) for name in RATES]


@cache
def made(name: str) -> Scenario:
    return read_scenario(read_document(shipped_scenarios() / f"{name}.yaml"), load_catalog(shipped_folder()), seed=1)


def study(name: str) -> Study:
    return open_study(read_document(shipped_scenarios() / f"{name}.yaml"), load_catalog(shipped_folder()))


def said(*arguments: object, capsys: pytest.CaptureFixture[str]) -> str:
    main([str(one) for one in arguments])
    return capsys.readouterr().out


@pytest.mark.parametrize("name", SHORT_AND_LONG)
def test_every_command_reads_the_rig(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scenario, recording = shipped_scenarios() / f"{name}.yaml", tmp_path / "run.parquet"
    said("simulate", scenario, "--duration", "2 s", "--truth", "--out", recording, capsys=capsys)
    assert f"at {RATES[name]:.0f} Hz, 2 s" in said("info", recording, capsys=capsys)
    filtered = said("filter", recording, "--chain", "order_lines", "--scenario", scenario, capsys=capsys)
    unit = UNITS.get(name, "N*m")
    assert f"error to true load {unit}\n" in filtered
    assert f"before {unit} " in filtered
    assert f"amplitude {unit} " in said("ordermap", recording, "--scenario", scenario, capsys=capsys)
    assert "mode 1" in said("modes", scenario, capsys=capsys)


@pytest.mark.parametrize("name", SHORT_AND_LONG)
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


def test_the_mixer_has_the_meshes_of_both_stages() -> None:
    rig = made("spur_gearbox_mixer").rig
    lines = {source.name: source for shaft in kinematics_of(rig).shafts for source in shaft.sources}
    assert lines["gear mesh of stage_1"].motor_order == pytest.approx(18)
    assert lines["gear mesh of stage_2"].motor_order == pytest.approx(19 / 3)
    drag = 0.084 * (120 * pi / 30) ** 2 + 0.8 / 4  # the pulses' mean is a quarter of their peak
    assert steady_torque(rig, "motor") * torque_gain(rig) > drag


@pytest.mark.parametrize("name", RATES)
def test_diagnose_reads_its_recordings(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scenario, recording = shipped_scenarios() / f"{name}.yaml", tmp_path / "run.parquet"
    said("simulate", scenario, "--duration", "2 s", "--out", recording, capsys=capsys)
    text = run_check(made(name), [read_recording(recording)]).text()
    assert f" {RATES[name]:.0f} " in text
    assert f" {UNITS.get(name, 'N*m')} " in text
    assert "scenario and recordings match" in text


def test_the_measured_line_follows_its_recording(tmp_path: Path) -> None:
    design = made("shaft_line_design").rig
    recorded = simulate(design, duration=4.0, seed=1, sample_rate=1e3, settling=1.0)
    channels = dict(recorded.channels)
    for name, part in (("true_load_Nm", "load_machine"), ("encoder_count", "motor")):
        channels[name] = replace(channels[name], truth=False, role="input", of=part)
    inputs = replace(recorded, channels=channels)
    again = simulate(under_inputs(made("shaft_line"), inputs).rig, duration=3.9, seed=1, sample_rate=1e3, settling=0.0)
    for place in ("outer_sensor", "inner_sensor"):
        before, after = (one.channels[f"{place}_V"].in_si()[1000:3900] for one in (recorded, again))
        assert after.mean() == pytest.approx(before.mean(), rel=2e-3)
        slow = sosfiltfilt(butter(4, 60, fs=1e3, output="sos"), after - before)  # below the modes of the clamped line
        assert slow.std() < 0.2 * before.std()


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


def test_init_names_the_rigs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = " ".join(said("init", tmp_path, capsys=capsys).split())
    assert all(name in text for name in ("wear_rig", "shaft_line,", *RATES))
    assert "filters" not in text
