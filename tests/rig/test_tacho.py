"""A tacho: what a simulation writes, what its sidecar may state, and who reads it."""

from math import pi
from pathlib import Path

import numpy as np
import pytest

import torquerig as tr
from torquerig.errors import InputError, RecordingError
from torquerig.orders.angle.tacho import recorded_motor_angle
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.files.sidecar import read_sidecar
from torquerig.recordings.set_point import set_point_speed

RIG = """
scenario: belt_axis
operating_point: {{motor_speed: 600 rpm}}
measured: torque_sensor
recording: {{sample_rate: 5 kHz}}
rig:
  motor: {{kind: motor, inertia: 1e-4 kg*m^2, viscous: 1e-4 N*m*s/rad, coulomb: 0.01 N*m, torque_limit: 2 N*m,
          pole_pairs: 4, slots: 12, current_loop_bandwidth: 500 Hz}}
  gearbox: {{kind: gear, ratio: 4, stiffness: 2000 N*m/rad, damping: 1 N*m*s/rad, input_inertia: 2e-5 kg*m^2}}
  torque_sensor: {{kind: torque_sensor, stiffness: 3000 N*m/rad, damping: 0.3 N*m*s/rad, inertia: 1e-4 kg*m^2,
                  sensitivity: 1 V/(N*m), bandwidth: 1000 Hz, noise_rms: 1 mV}}
  drum: {{kind: body, inertia: 2e-3 kg*m^2, viscous: 0.02 N*m*s/rad}}
  speed_controller: {{kind: speed_controller, motor: motor, kp: 0.02 N*m*s/rad, ki: 0.2 N*m/rad}}
  shake: {{kind: torque_ripple, at: drum, amplitudes: {{1: 0.1 N*m, 2: 0.05 N*m}}}}
  pulses: {{kind: tacho, at: {at}, {pulses}}}
"""


def scenario(folder: Path, *, at: str = "motor", pulses: str = "pulses_per_rev: 2") -> Path:
    path = folder / "axis.yaml"
    path.write_text(RIG.format(at=at, pulses=pulses))
    return path


@pytest.mark.parametrize(
    ("at", "pulses", "per_motor_turn"),
    [("motor", "pulses_per_rev: 2", 2.0), ("drum", "pulses_per_rev: 1", 0.25), ("drum", "teeth: 60", 15.0)],
)
def test_a_simulated_tacho_gives_the_true_angle(tmp_path, at, pulses, per_motor_turn):
    made = tr.simulate(scenario(tmp_path, at=at, pulses=pulses), duration=3.0, seed=1)
    true = made.channels["true_motor_angle_rad"].values
    write_recording(made.without_truth(), tmp_path / "run.parquet")
    read = read_recording(tmp_path / "run.parquet")
    assert read.run.others["tacho_pulses_per_motor_turn"] == pytest.approx(per_motor_turn)
    angle = recorded_motor_angle(read, ratio=4.0)
    assert angle is not None
    # an edge is known to a sample of 0.2 ms: 0.013 rad at 600 rpm; the unsteadiness within one turn of the drum (four
    # of the motor) is not seen by one pulse per turn
    wrong = (angle.values - true)[2000:-2000]
    assert np.ptp(wrong) < (0.05 if per_motor_turn >= 1 else 0.2)
    assert "from the tacho pulses" in angle.origin


def test_the_filter_follows_a_tacho(tmp_path):
    made = tr.simulate(scenario(tmp_path), duration=6.0, seed=1).without_truth()
    clean = tr.filter(made, "order_lines", scenario=scenario(tmp_path))
    assert clean.torque().std() < 0.3 * made.torque().std()


def test_pulses_that_the_rate_cannot_show_are_refused(tmp_path):
    with pytest.raises(RecordingError, match="samples a second do not resolve"):
        tr.simulate(scenario(tmp_path, pulses="teeth: 400"), duration=0.5, seed=1)


@pytest.mark.parametrize("pulses", ["duty: 0.5", "teeth: 3, pulses_per_rev: 3"])
def test_a_tacho_needs_one_count(tmp_path, pulses):
    with pytest.raises(InputError, match="either pulses_per_rev or teeth"):
        tr.simulate(scenario(tmp_path, pulses=pulses), duration=0.5, seed=1)


def sheet(folder: Path, entry: str, run: str = "{}") -> Path:
    path = folder / "run.yaml"
    path.write_text(f"channels:\n  pulses: {entry}\nrun: {run}\n")
    return path


@pytest.mark.parametrize(
    ("entry", "others"),
    [
        ("{quantity: tacho, unit: V, pulses_per_rev: 2}", {"tacho_pulses_per_motor_turn": 2.0}),
        ("{quantity: tacho, unit: V, teeth: 60, shaft: output}", {"tacho_pulses_per_output_turn": 60.0}),
        ("{quantity: tacho, unit: V, teeth: 60, pulses_per_rev: 60}", {"tacho_pulses_per_motor_turn": 60.0}),
    ],
)
def test_a_sheet_states_the_pulses_at_the_channel(tmp_path, entry, others):
    assert read_sidecar(sheet(tmp_path, entry)).run.others == others


@pytest.mark.parametrize(
    ("entry", "run", "said"),
    [
        ("{quantity: torque, unit: N*m, teeth: 60}", "{}", "belongs to a tacho"),
        ("{quantity: tacho, unit: V, shaft: output}", "{}", "add pulses_per_rev: N"),
        ("{quantity: tacho, unit: V, teeth: 60, pulses_per_rev: 1}", "{}", "contradict"),
        ("{quantity: tacho, unit: V, teeth: 60}", "{tacho_pulses_per_motor_turn: 60}", "stated twice"),
        ("{quantity: tacho, unit: V, teeth: 60, shaft: input}", "{}", "shaft"),
    ],
)
def test_what_contradicts_in_a_sheet_is_refused_with_its_line(tmp_path, entry, run, said):
    with pytest.raises(InputError, match=said) as refused:
        read_sidecar(sheet(tmp_path, entry, run))
    assert "run.yaml:2" in str(refused.value)


def test_a_tacho_of_known_pulses_replaces_the_set_point(tmp_path):
    made = tr.simulate(scenario(tmp_path), duration=3.0, seed=1).without_truth()
    from dataclasses import replace

    unknown = replace(made, run=replace(made.run, speed=None))
    assert set_point_speed(unknown, "test") == pytest.approx(20 * pi, rel=2e-3)
