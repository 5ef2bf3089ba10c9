"""Rigs of the fleet: readable scenarios, the same files for the same seed, no change by an effect of size zero."""

import hashlib
from dataclasses import replace

import numpy as np
import pytest
import yaml

from proof.fleet.design import DRIVES, LOADS, MOTORS
from proof.fleet.draw import draw_case, draw_kinds
from proof.fleet.effects import MECHANISMS
from proof.fleet.effects.backlash import Backlash
from proof.fleet.effects.bearing_defect import BearingDefect
from proof.fleet.effects.blade_pass import BladePass
from proof.fleet.effects.clipping import Clipping
from proof.fleet.effects.cogging import Cogging
from proof.fleet.effects.commutation_ripple import CommutationRipple
from proof.fleet.effects.gear_mesh import GearMesh
from proof.fleet.effects.mains_interference import MainsInterference
from proof.fleet.effects.pwm_aliasing import PwmAliasing
from proof.fleet.effects.quadratic_drag import QuadraticDrag
from proof.fleet.effects.quantization import Quantization
from proof.fleet.effects.sensor_bandwidth import SensorBandwidth
from proof.fleet.effects.sensor_drift import SensorDrift
from proof.fleet.effects.signal_dropout import SignalDropout
from proof.fleet.effects.stribeck_friction import StribeckFriction
from proof.fleet.effects.torsional_mode import TorsionalMode
from proof.fleet.plans import PLANS, Run
from proof.fleet.recording import record, write_recordings
from proof.fleet.rig import draw_rig
from proof.fleet.stated import Stated
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.recordings.files import read_recording
from torquerig.reporting.diagnosis.run_check import run_check
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.recorded.as_compared import as_compared

SHORT = 2.2  # [s] of a run; diagnose refuses less than 2 s
STEP = 1e-6  # of a coarse converter; below half of the fleet's finest step it changes no code
NOTHING = {
    "gear_mesh": GearMesh("gearbox", 0, 30, 0.0, 0.0, 0.3, 0.2, 1.0, 0.0),
    "commutation_ripple": CommutationRipple("motor", 24, 0.0, 0.0, 0.1),
    "torsional_mode": TorsionalMode("body", 40.0, 0.0, 0.01),
    "backlash": Backlash("gearbox", 0, 0.0, 1.0),
    "stribeck_friction": StribeckFriction("body", 0.0, 0.0, 0.5, 1.0),
    "bearing_defect": BearingDefect("body", 3.2, 300.0, 0.05, 0.0, 0.01, 0.0),
    "mains_interference": MainsInterference("sensor", 50.0, (0.0, 0.0, 0.0, 0.0)),
    "sensor_drift": SensorDrift("sensor", 0.0, None),
    "clipping": Clipping("sensor", 10.0),
    "quantization": Quantization("sensor", STEP),
    "pwm_aliasing": PwmAliasing("sensor", 400.0, 0.0),
    "blade_pass": BladePass("body", 5, 0.0, 0.0),
    "quadratic_drag": QuadraticDrag("body", 0.0),
    "cogging": Cogging("motor", (12,), (0.0,), (0.0,)),
}


def shortened(rig):
    return replace(rig, runs=tuple(replace(run, duration=SHORT) for run in rig.runs[:1]))


@pytest.fixture(scope="module")
def geared():
    return shortened(
        draw_rig("geared", (1, 2), plans=("one_speed",), motors=("servo",), drives=("one_stage",), loads=("brake",))
    )


@pytest.mark.parametrize("number", range(36))
def test_every_scenario_can_be_read(number, tmp_path):
    kinds = {"drives": (DRIVES[number % 6],), "loads": (LOADS[number // 6 % 6],), "motors": (MOTORS[number % 3],)}
    rig = draw_rig("rig", (5, number), **kinds)
    path = tmp_path / "scenario.yaml"
    path.write_text(yaml.safe_dump(rig.scenario(), sort_keys=False))
    made = read_scenario(read_document(path), load_catalog(shipped_folder()), seed=0)
    assert {part.name for part in made.rig.parts} >= set(rig.design.parts)
    assert 0.009 < rig.design.scale.torque < 1001.0
    assert 1000.0 <= rig.design.sample_rate <= 51200.0


@pytest.mark.parametrize("drive", DRIVES)
def test_recordings_pass_the_check_of_diagnose(drive, tmp_path):
    rig = draw_rig("rig", (6, DRIVES.index(drive)), drives=(drive,))
    rig = replace(rig, runs=tuple(replace(run, duration=SHORT) for run in rig.runs))
    write_recordings(rig, tmp_path)
    runs = [read_recording(path) for path in sorted(tmp_path.glob("run*.parquet"))]
    scenario = read_scenario(read_document(tmp_path / "scenario.yaml"), load_catalog(shipped_folder()), seed=0)
    compared = as_compared(scenario, runs)
    assert "scenario and recordings match" in run_check(scenario, runs).text()
    assert [one.name for one in compared.recordings] == [one.name for one in runs]


def test_the_same_seed_gives_the_same_bytes(geared, tmp_path):
    digests = []
    for name in ("first", "second"):
        write_recordings(geared, tmp_path / name)
        files = sorted((tmp_path / name).iterdir())
        digests.append([hashlib.sha256(path.read_bytes()).hexdigest() for path in files])
    assert digests[0] == digests[1]
    other = replace(geared, seed=(1, 3))
    assert not np.array_equal(record(other, 0).volts, record(geared, 0).volts)


def test_drawing_is_repeatable():
    first, second = (draw_rig("rig", (9, 4)) for _ in range(2))
    assert first.scenario() == second.scenario()
    assert first.truth == second.truth
    assert first.laws == second.laws


@pytest.mark.parametrize("kind", sorted(NOTHING))
def test_an_effect_of_size_zero_changes_nothing(kind, geared):
    plain = record(geared, 0, effects=())
    rig = replace(geared, effects=(NOTHING[kind],))
    # a coarse converter's step is a microvolt here, all else must leave every code as it is
    assert np.max(np.abs(record(rig, 0).volts - plain.volts)) <= STEP
    assert record(rig, 0).mean_torque == pytest.approx(plain.mean_torque, rel=1e-9)


def test_a_stated_bandwidth_and_no_dropout_change_nothing(geared):
    plain = record(geared, 0, effects=()).volts
    stated = float(geared.design.parts[geared.design.sensor]["bandwidth"].split()[0])
    rig = replace(geared, effects=(SensorBandwidth("sensor", stated),))
    assert np.array_equal(record(rig, 0).volts, plain)
    lost = record(replace(geared, effects=(SignalDropout("sensor", 0.01, 30.0, 0.0),)), 0).volts
    changed = lost != plain
    assert 0 < changed.sum() < 0.2 * plain.size
    assert np.all(lost[changed] == 0.0)


def test_every_mechanism_of_the_contract_can_be_drawn():
    assert sorted({*NOTHING, "sensor_bandwidth", "signal_dropout"}) == sorted(MECHANISMS)
    kinds = [draw_kinds(number, np.random.default_rng(number)) for number in range(64)]
    assert {one[0] for one in kinds if one} == set(MECHANISMS)
    assert {len(one) for one in kinds} == {0, 1, 2, 3, 4}


def test_a_drawn_effect_shows_and_is_in_no_scenario():
    case = draw_case("case", (3, 1), ("blade_pass",))
    assert case.shown[0].counts
    assert case.shown[0].size > 0.0
    assert all(part["kind"] != "blade_pass" for part in case.rig.scenario()["rig"].values())


def test_true_values_lie_around_the_stated_ones():
    rigs = [draw_rig("rig", (8, number)) for number in range(12)]
    numbers = np.array([value for rig in rigs for value in rig.numbers().values()])
    assert np.abs(np.log(numbers)).max() < 0.8  # 2.5 standard deviations of 0.3
    assert 0.05 < np.std(np.log(numbers)) < 0.3
    assert isinstance(rigs[0].design.parts[rigs[0].design.body]["inertia"], Stated)


def test_all_plans_occur():
    drawn = {draw_rig("rig", (7, number), motors=("servo",)).plan for number in range(60)}
    assert drawn == set(PLANS)
    assert Run(1.0, "steady", 0, 1.0).duration == 1.0
