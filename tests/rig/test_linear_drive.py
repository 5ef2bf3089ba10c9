"""A linear drive: forces, modes, travel deviation and units against closed forms."""

from __future__ import annotations

from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest
import yaml

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.metrics.load_error import load_error
from torquerig.metrics.truth_error import truth_error
from torquerig.rig.steady import steady_torque
from torquerig.scenario.kinematics import kinematics_of, ratio_text, shaft_turns_to, torque_gain
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate
from torquerig.simulation.true_lines import true_lines, with_true_lines

LEAD, ROTOR, MASS, STIFFNESS = 0.010, 5e-5, 12.0, 5e7


def axis(tmp_path: Path, *, point: dict | None = None, **parts: dict) -> Scenario:
    """Return a motor on a screw with a slide and a force sensor, with further parts or changed ones."""
    rig = {
        "motor": {"kind": "motor", "inertia": f"{ROTOR} kg*m^2", "torque_limit": "5 N*m"},
        "screw": {"kind": "linear_drive", "lead": "10 mm", "stiffness": "50 N/um", "damping": "2 kN*s/m"},
        "table": {"kind": "slide", "mass": f"{MASS} kg"},
        "force_sensor": {
            "kind": "force_sensor", "stiffness": "200 N/um", "damping": "500 N*s/m", "mass": "0.5 kg",
            "bandwidth": "1 kHz", "sensitivity": "5 mV/N",
        },
        "tool": {"kind": "slide", "mass": "1 kg"},
        "speed_controller": {"kind": "speed_controller", "kp": "0.03 N*m*s/rad", "ki": "0.5 N*m/rad"},
    }  # fmt: skip
    data = {
        "operating_point": point or {"output_speed": "50 mm/s"},
        "recording": {"sample_rate": "5 kHz"},
        "measured": "force_sensor",
        "rig": {name: {**rig.get(name, {}), **parts.get(name, {})} for name in (*rig, *parts)},
    }
    file = tmp_path / "axis.yaml"
    file.write_text(yaml.safe_dump(data, sort_keys=False), encoding="utf-8")
    return read_scenario(read_document(file), load_catalog(shipped_folder()), seed=1)


def test_speed_and_torque_follow_from_the_lead(tmp_path: Path) -> None:
    made = axis(
        tmp_path, screw={"efficiency": 0.9}, load={"kind": "particle_load", "at": "tool", "hit_rms": 0, "slow_rms": 0,
                                                   "mean_by_occupancy_percent": {0: "300 N"}, "smoothing": "1 mm/s"},
    )  # fmt: skip
    assert made.rig.run.speed == pytest.approx(0.05 * 2 * pi / LEAD)
    assert torque_gain(made.rig) == pytest.approx(0.9 * 2 * pi / LEAD)
    assert steady_torque(made.rig, "motor") == pytest.approx(300 * LEAD / (2 * pi * 0.9), rel=1e-9)
    recording = simulate(made.rig, duration=1.0, seed=1, sample_rate=5e3, settling=1.0)
    assert recording.torque().mean() == pytest.approx(300.0, rel=1e-3)  # codes of 0.06 N, end of the settling
    assert recording.channels["true_motor_torque_Nm"].values.mean() == pytest.approx(
        300 * LEAD / (2 * pi * 0.9), rel=1e-3
    )
    assert truth_error(recording, recording) < 0.5
    assert load_error(recording, recording).energy_percent == pytest.approx(0.0, abs=0.2)


def test_the_mode_of_rotor_against_table(tmp_path: Path) -> None:
    rig = axis(tmp_path, force_sensor={"stiffness": "1000 kN/mm"}).rig
    moved = MASS + 0.5 + 1.0
    expected = sqrt(STIFFNESS * (1 / moved + (LEAD / 2 / pi) ** 2 / ROTOR)) / 2 / pi
    found = matrices(lower(rig, 1)).undamped_frequencies()
    assert min(one for one in found if one > 1) == pytest.approx(expected, rel=2e-3)  # the sensor is stiff, not rigid


def test_lines_are_those_of_the_screw(tmp_path: Path) -> None:
    rig = axis(tmp_path).rig
    kinematics = kinematics_of(rig)
    assert kinematics.ratio == 1
    assert [(shaft.name, shaft.ratio) for shaft in kinematics.shafts] == [("motor", 1.0)]
    assert rig.run.gear_ratio == 1
    assert shaft_turns_to(rig, rig.measured) == 1
    assert ratio_text(rig) == "10 mm per turn"


def test_travel_deviation_shows_once_a_turn(tmp_path: Path) -> None:
    probe = {"kind": "probe", "quantity": "speed", "at": "table"}
    made = axis(tmp_path, screw={"lead_error": ["2 um"]}, measuring=probe)
    recording = simulate(made.rig, duration=4.0, seed=1, sample_rate=5e3, settling=1.0)
    angle = recording.channels["true_motor_angle_rad"].values
    velocity = recording.channels["measuring_m_s"].values - recording.channels["true_motor_speed_rad_s"].values * (
        LEAD / 2 / pi
    )
    line = 2 * abs(np.mean(velocity * np.exp(-1j * angle)))
    assert line == pytest.approx(2e-6 * 2 * pi * 5, rel=1e-2)  # 5 turns/s, far below the first mode


def test_lines_in_a_force_are_known_too(tmp_path: Path) -> None:
    made = axis(
        tmp_path, ripple={"kind": "torque_ripple", "at": "motor", "group": "cogging", "amplitudes": {4: "0.02 N*m"}},
        load={"kind": "particle_load", "at": "tool", "mean_by_occupancy_percent": {0: "100 N"}, "smoothing": "1 mm/s"},
    )  # fmt: skip
    recording = simulate(made.rig, duration=1.0, seed=1, sample_rate=5e3)
    lines = true_lines(with_true_lines(recording, made.rig, seed=1))
    assert lines is not None
    assert (lines.quantity, lines.unit) == ("force", "N")
    assert lines.values.std() > 0


@pytest.mark.parametrize(
    ("changes", "point", "words"),
    [
        ({"screw": {"lead": "0 mm"}}, None, "rig.screw.*lead 0 moves nothing"),
        ({"screw": {"input_inertia": "1 kg"}}, None, r"input_inertia.*kg\*m\^2"),
        ({"screw": {"coulomb": "1 N*m"}}, None, "coulomb.*is a torque"),
        ({}, {"output_speed": "60 rpm"}, "output_speed.*is a speed|output_speed.*'60 rpm'"),
        ({}, {"motor_speed": "50 mm/s"}, "motor_speed.*'50 mm/s'"),
    ],
)
def test_units_follow_the_motion(tmp_path: Path, changes: dict, point: dict | None, words: str) -> None:
    with pytest.raises(InputError, match=words):
        axis(tmp_path, point=point, **changes)
