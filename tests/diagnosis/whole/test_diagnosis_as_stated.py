"""Whole diagnoses: what they say of clean rigs, of what no library has, and of a library without the class."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.diagnosis.engine import Outcome, diagnose
from torquerig.diagnosis.fitting.calibration import LIMIT, calibrated
from torquerig.diagnosis.judging.held_out import held_out
from torquerig.diagnosis.outcome import as_json
from torquerig.document import read_document
from torquerig.inference.knobs import Knob, nuisance_knobs, turned
from torquerig.mechanisms import GearMesh, TorqueRipple
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.writing import scenario_text

pytestmark = pytest.mark.long  # one whole diagnosis for the file

ThreeRuns = Callable[..., list[Recording]]
MESH = GearMesh(name="hidden", order_output=84.0, transmission_error=(6e-5, 1.5e-5))


@pytest.fixture(scope="module")
def meshed(known_rig: Scenario, three_runs: ThreeRuns) -> list[Recording]:
    return three_runs(known_rig.rig + MESH, 4)


@pytest.fixture(scope="module")
def mesh_outcome(known_rig: Scenario, meshed: list[Recording]) -> Outcome:
    return diagnose(known_rig, meshed)


def drawn_rig(scenario: Scenario, seed: int) -> Scenario:
    """The scenario with every uncertain number of the real rig drawn by its spread."""
    rng = np.random.default_rng(seed)
    rig = scenario.rig
    knobs = [
        Knob(*name.rsplit(".", 1), spread=estimate.rel_sd)
        for name, estimate in scenario.uncertainties.items()
        if estimate.rel_sd
    ]
    rig = turned(rig, knobs, rng.standard_normal(len(knobs)))
    for ripple in rig.parts_of(TorqueRipple):
        sizes = {order: size * np.exp(0.2 * rng.standard_normal()) for order, size in ripple.amplitudes.items()}
        rig = rig.changed(replace(ripple, amplitudes=sizes))
    return replace(scenario, rig=rig)


@pytest.mark.parametrize("seed", [11, pytest.param(12, marks=pytest.mark.full)])
def test_wrong_numbers_are_not_missing_physics(seed: int, wear_rig: Scenario, three_runs: ThreeRuns) -> None:
    """Every uncertain number of the rig is drawn; what is left after calibration is chance."""
    made = diagnose(wear_rig, three_runs(drawn_rig(wear_rig, seed).rig, seed)).diagnosis
    assert made.verdict == "adequate"
    assert made.findings == ()
    assert made.fit.before <= made.fit.nominal
    assert made.fit.before < 1.7, "a true model leaves about 1 on data that no fit has seen"
    assert made.fit.after == made.fit.before


def test_calibration_finds_a_wrong_number(known_rig: Scenario, three_runs: ThreeRuns) -> None:
    wear_part = known_rig.rig.part("wear_part")
    heavier = known_rig.rig.changed(replace(wear_part, inertia=1.2 * wear_part.inertia))  # type: ignore[attr-defined, call-arg]
    outcome = diagnose(known_rig, three_runs(heavier, 7))
    fitted = outcome.before.model.rig.part("wear_part").inertia  # type: ignore[attr-defined]
    # its stated spread of 10 % pulls back by a little
    assert fitted == pytest.approx(1.2 * wear_part.inertia, rel=0.05)  # type: ignore[attr-defined]
    assert outcome.diagnosis.verdict == "adequate"


def test_each_feature_of_a_true_model_lies_about_one_spread_off(known_rig: Scenario, three_runs: ThreeRuns) -> None:
    outcome = diagnose(known_rig, three_runs(known_rig.rig, 8))
    misfits = outcome.before.model.misfits
    residuals = np.concatenate([misfit.all() for misfit in misfits])
    assert np.sum(residuals**2) / sum(misfit.seen for misfit in misfits) < 1.3
    assert np.abs(residuals).max() < 6.0


def test_knobs_turn_what_they_name(wear_rig: Scenario) -> None:
    rig = wear_rig.rig
    knobs = nuisance_knobs(rig, wear_rig.uncertainties, occupancies=[5.0, 15.0])
    names = [knob.name for knob in knobs]
    assert len(set(names)) == len(names)
    assert {"wear_part.inertia", "load.mean_by_occupancy_percent.5", "load.hit_rms", "shaft.amplitudes.2"} <= set(names)
    same = turned(rig, knobs, np.zeros(len(knobs)))
    assert same.parts == rig.parts
    for index, knob in enumerate(knobs):
        position = np.zeros(len(knobs))
        position[index] = 1.0
        moved = turned(rig, knobs, position)
        value = knob.value(rig)
        expected = value * np.exp(knob.spread) if knob.factor else value + knob.spread
        assert knob.value(moved) == pytest.approx(expected), knob.name
        changed = [a.name for a, b in zip(moved.parts, rig.parts, strict=True) if a != b]
        assert changed == [knob.part]


def test_a_fit_stays_within_its_limits_and_pays_for_its_way(known_rig: Scenario, mesh_outcome: Outcome) -> None:
    case = mesh_outcome.before
    again = calibrated(case.nominal, case.seen, case.model.knobs)
    assert np.abs(again.positions).max() <= LIMIT
    still = calibrated(case.nominal, case.seen, ())
    assert again.cost <= still.cost


@pytest.mark.full
def test_the_same_input_and_seed_give_the_same_json(
    known_rig: Scenario, meshed: list[Recording], mesh_outcome: Outcome
) -> None:
    again = diagnose(known_rig, meshed)
    assert json.dumps(as_json(again.diagnosis)) == json.dumps(as_json(mesh_outcome.diagnosis))


def test_the_written_json_keeps_the_contract(mesh_outcome: Outcome, meshed: list[Recording]) -> None:
    data = json.loads(json.dumps(as_json(mesh_outcome.diagnosis), allow_nan=False))
    assert data["schema"] == "torquerig.diagnosis/1"
    assert data["verdict"] == "missing_physics"
    assert data["mismatch"]
    for place in data["mismatch"]:
        assert place["domain"] in {"order", "frequency", "time", "speed", "level", "distribution"}
        assert place["axis"] in {"output_shaft", "motor_shaft", "Hz", "s", "rpm", "V"}
        assert all(isinstance(place[key], float) for key in ("at", "width", "excess_dB", "share_of_misfit", "p_value"))
        assert 0 <= place["p_value"] <= 1
        assert 0 <= place["share_of_misfit"] <= 1
        assert set(place["recordings"]) <= {recording.name for recording in meshed}
    assert {(place["axis"], round(place["at"])) for place in data["mismatch"]} >= {("output_shaft", 84)}
    (finding,) = data["findings"]
    assert finding["mechanism"] == "gear_mesh"
    assert 0.5 < finding["confidence"] <= 1
    assert set(finding["parameters"]) == {"order_output", "transmission_error_rad", "amplitude_Nm"}
    for stated in finding["parameters"].values():
        low, high = stated["ci95"]
        assert low <= stated["value"] <= high
        assert isinstance(stated["unit"], str)
    assert isinstance(finding["equivalent_to"], list)
    assert finding["explanation"].endswith(".")
    fit = data["fit"]
    assert 0 <= fit["after"]["heldout_misfit"] < fit["before"]["heldout_misfit"]
    gain = 1 - fit["after"]["heldout_misfit"] / fit["before"]["heldout_misfit"]
    assert fit["improvement"]["value"] == pytest.approx(gain, abs=1e-4)
    low, high = fit["improvement"]["ci95"]
    assert low <= gain <= high
    assert [used["file"] for used in data["recordings"]] == [recording.name for recording in meshed]
    assert {used["used_for"] for used in data["recordings"]} <= {"fit", "held_out", "split"}
    assert data["recordings"][0]["speed_rpm"] == pytest.approx(1004.0, rel=1e-3)


def test_the_written_model_simulated_again_gives_the_figures_after(
    known_rig: Scenario, mesh_outcome: Outcome, tmp_path: Path
) -> None:
    written = tmp_path / "model.yaml"
    written.write_text(scenario_text(mesh_outcome.completed, title="mesh", operating_point={}), encoding="utf-8")
    rig = read_scenario(read_document(written), load_catalog(shipped_folder()), seed=0).rig
    before = mesh_outcome.before
    again = held_out(before.nominal, before.model.rig, rig, mesh_outcome.held, seed=0)
    assert again.after == pytest.approx(mesh_outcome.diagnosis.fit.after, rel=1e-6)
    assert again.after < 0.5 * again.before


def test_without_its_class_a_mesh_is_unexplained(
    known_rig: Scenario, meshed: list[Recording], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr("torquerig.mechanisms.GearMesh")
    made = diagnose(known_rig, meshed).diagnosis
    assert made.verdict == "unexplained"
    assert "gear_mesh" not in [finding.mechanism for finding in made.findings]
    assert any(place.axis == "output_shaft" and round(place.at) == 84 for place in made.mismatch)


def test_what_no_library_has_stays_unexplained_and_is_located(known_rig: Scenario, three_runs: ThreeRuns) -> None:
    """A whistle that sweeps from 300 to 900 Hz over each run: no order, no fixed frequency, no mode."""
    runs = []
    for recording in three_runs(known_rig.rig, 9):
        time = np.arange(recording.samples) / recording.sample_rate
        swept = 300 * time + (900 - 300) / (2 * recording.duration) * time**2
        volts = recording.channels["torque_V"].values + 0.06 * np.cos(2 * np.pi * swept)
        runs.append(recording.with_values("torque_V", volts))
    made = diagnose(known_rig, runs).diagnosis
    assert made.verdict == "unexplained"
    assert made.findings == ()
    assert {place.recordings for place in made.mismatch} == {(recording.name,) for recording in runs}
    for place in made.mismatch:
        assert (place.domain, place.axis) == ("frequency", "Hz")
        assert (place.at, place.width) == pytest.approx((600.0, 600.0), abs=1.0)
    assert sum("a line sweeps from" in remark for remark in made.remarks) == len(runs)


def test_a_second_effect_of_a_kind_is_found_beside_the_scenarios_own(
    known_rig: Scenario, three_runs: ThreeRuns
) -> None:
    """A written model names its findings by their class; given back as the nominal one, the names must be free."""
    first = GearMesh(name="gear_mesh", order_output=61.0, transmission_error=(5e-5,))
    nominal = replace(known_rig, rig=known_rig.rig + first)
    made = diagnose(nominal, three_runs(nominal.rig + MESH, 4)).diagnosis
    assert [finding.mechanism for finding in made.findings] == ["gear_mesh"]
    assert made.findings[0].parameters["order_output"].value == pytest.approx(84.0)


def test_a_sheet_that_the_lines_of_the_torque_contradict_is_said_and_located(
    known_rig: Scenario, three_runs: ThreeRuns
) -> None:
    runs = three_runs(known_rig.rig, 8, encoder=False)
    wrong = replace(runs[0].run, speed=1.3 * (runs[0].run.speed or 0.0))
    made = diagnose(known_rig, [replace(runs[0], run=wrong), *runs[1:]]).diagnosis
    (off,) = (remark for remark in made.remarks if "the sidecar states" in remark)
    assert "the sidecar states 1300 rpm, but the lines of its torque fit 1004 rpm" in off
    assert any("no fault-free rigs were simulated for this scenario" in remark for remark in made.remarks)
    (place,) = [place for place in made.mismatch if place.axis == "rpm"]
    assert place.at == pytest.approx(1004.0, rel=1e-3)


def test_a_sheet_that_the_encoder_contradicts_is_said_and_located(known_rig: Scenario, three_runs: ThreeRuns) -> None:
    runs = three_runs(known_rig.rig, 8)
    wrong = replace(runs[0].run, speed=1.3 * (runs[0].run.speed or 0.0))
    made = diagnose(known_rig, [replace(runs[0], run=wrong), *runs[1:]]).diagnosis
    (off,) = (remark for remark in made.remarks if "the sidecar states" in remark)
    assert "the sidecar states 1300 rpm, but the channel encoder_count shows 1004 rpm" in off
    (place,) = [place for place in made.mismatch if place.axis == "rpm"]
    assert place.at == pytest.approx(1004.0, rel=1e-3)
    assert place.recordings == (runs[0].name,)
