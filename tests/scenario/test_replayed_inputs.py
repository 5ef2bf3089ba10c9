"""A recorded rig simulated under its own inputs, from scenario files: torque, current, speed, force."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate

RIG = """
operating_point: {motor_speed: 600 rpm}
measured: sensor
rig:
  motor: {kind: motor, inertia: 1.5 kg*cm^2, torque_limit: 5 N*m, viscous: 1.0e-4 N*m*s/rad}
  gearbox: {kind: gear, ratio: 5, stiffness: 11300 N*m/rad, damping: 2 N*m*s/rad, output_inertia: 7 kg*cm^2}
  sensor: {kind: coupling, stiffness: 1100 N*m/rad, damping: 0.12 N*m*s/rad, inertia: 4.0e-5 kg*m^2}
  wear_part: {kind: body, inertia: 20 kg*cm^2, viscous: 0.02 N*m*s/rad}
  friction: {kind: stribeck_friction, coulomb: 0.4 N*m, static: 0.5 N*m, stribeck_speed: 2 rad/s}
"""
CONTROLLED = "  controller: {kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}\n"


def scenario(tmp_path: Path, *lines: str, base: str = RIG) -> Scenario:
    text = base + "".join(f"  {line}\n" for line in lines)
    return read_scenario(parse_document(text, tmp_path / "rig.yaml"), Catalog(), seed=1)


@pytest.fixture
def recorded(tmp_path: Path) -> Recording:
    """A run from standstill of the springs, its truth written as measured channels."""
    made = simulate(read_scenario(parse_document(RIG + CONTROLLED, tmp_path / "rig.yaml"), Catalog(), seed=1).rig,
                    duration=0.4, seed=1, settling=0.0)  # fmt: skip
    torque, speed = (made.channels[f"true_motor_{name}"].values for name in ("torque_Nm", "speed_rad_s"))
    channels = {
        "motor_torque_Nm": Channel(values=torque, quantity="motor_torque", unit="N*m"),
        "current_A": Channel(values=torque / 0.11, quantity="current", unit="A"),
        "speed_rpm": Channel(values=speed * 30 / pi, quantity="motor_speed", unit="rpm", si_per_unit=pi / 30),
    }
    write_recording(Recording(sample_rate=made.sample_rate, channels=channels), tmp_path / "run.parquet")
    return made


def sensor(rig: Rig, duration: float = 0.4) -> np.ndarray:
    return simulate(rig, duration=duration, seed=1, settling=0.0).channels["true_sensor_torque_Nm"].values


@pytest.mark.parametrize(
    "line",
    [
        "replay: {kind: replayed_torque, recording: run.parquet}",
        "replay: {kind: replayed_torque, recording: run.parquet, channel: current_A, torque_constant: 0.11 N*m/A}",
        "replay: {kind: imposed_motion, recording: run.parquet, channel: motor_speed}",
    ],
    ids=["torque", "current", "speed"],
)
def test_its_own_input_gives_its_own_reading(recorded: Recording, tmp_path: Path, line: str) -> None:
    """Without the controller; what differs is how torque or speed runs between two samples."""
    reading = recorded.channels["true_sensor_torque_Nm"].values
    found = sensor(scenario(tmp_path, line).rig)
    assert found == pytest.approx(reading, abs=2e-3 * np.ptp(reading))


def test_torque_mode_replays_through_limit_and_lag(recorded: Recording, tmp_path: Path) -> None:
    """Held for a sample and through a lag of 0.32 ms, in closed form."""
    line = "drive: {kind: torque_controller, recording: run.parquet, channel: motor_torque_Nm}"
    made = simulate(scenario(tmp_path, line).rig, duration=0.4, seed=1, settling=0.0)
    late = made.channels["true_motor_torque_Nm"].values
    left = np.exp(-2 * pi * 500 / made.sample_rate)  # of a step, after a sample
    expected = [0.0]
    for asked in recorded.channels["true_motor_torque_Nm"].values[:-1]:
        expected.append(asked + (expected[-1] - asked) * left)
    assert late == pytest.approx(np.array(expected), abs=1e-5)


def test_a_load_is_replayed_behind_the_gear_and_the_loop_holds_against_it(recorded: Recording, tmp_path: Path) -> None:
    """-5 times the motor's torque on the wear part of a controlled rig: the sensor carries it on average."""
    line = "load: {kind: replayed_torque, at: wear_part, recording: run.parquet, factor: -5}"
    with_it = sensor(scenario(tmp_path, CONTROLLED.strip(), line).rig)[5000:].mean()
    without = sensor(scenario(tmp_path, CONTROLLED.strip()).rig)[5000:].mean()
    load = 5 * recorded.channels["true_motor_torque_Nm"].values[5000:].mean()
    assert with_it - without == pytest.approx(load, rel=0.03)


def test_what_is_fed_forward_leaves_less_to_the_loop(recorded: Recording, tmp_path: Path) -> None:
    """The friction's torque known beforehand: the speed sags less from the start on."""
    sags = []
    for line in ((), ("ahead: {kind: torque_controller, torque: 0.14 N*m, beside: controller}",)):
        made = simulate(scenario(tmp_path, CONTROLLED.strip(), *line).rig, duration=0.2, seed=1, settling=0.0)
        sags.append(20 * pi - made.channels["true_motor_speed_rad_s"].values[500:].mean())
    assert 0 <= abs(sags[1]) < 0.3 * sags[0]


def test_the_encoder_that_names_the_controller_feeds_it(tmp_path: Path) -> None:
    """Order 2, 1 mrad at 600 rpm, see handbook 2.5: the loop answers to k w a as its transfer says.

    The recorded counts hold the error whether the loop reads them or not.
    """
    encoder = "{kind: motor_encoder, counts_per_rev: 1000000, angle_error: {2: 1 mrad}"
    lines = {}
    for fed in ("}", ", controller: controller, speed_filter: 0.2 ms}"):
        made_rig = scenario(tmp_path, CONTROLLED.strip(), f"encoder: {encoder}{fed}").rig
        made = simulate(made_rig, duration=1.0, seed=1)
        angle = made.channels["true_motor_angle_rad"].values
        columns = np.column_stack([np.ones(angle.size), np.cos(2 * angle), np.sin(2 * angle)])
        torque = np.linalg.lstsq(columns, made.channels["true_motor_torque_Nm"].values, rcond=None)[0]
        counted = np.linalg.lstsq(columns, made.channels["encoder_count"].in_si() - angle, rcond=None)[0]
        assert np.hypot(counted[1], counted[2]) == pytest.approx(1e-3, rel=0.02)
        lines[fed] = np.hypot(torque[1], torque[2])
    assert lines["}"] < 1e-5
    system, s = matrices(lower(made_rig, 1)), 2j * 20 * pi
    swing = np.linalg.inv(s**2 * system.mass + s * system.damping + system.stiffness)[0, 0]
    loop = (0.05 + 0.5 / s) / (1 + s / (2 * pi * 500)) / (1 + s * 0.2e-3)
    expected = abs(loop / (1 + loop * s * swing)) * 2 * 20 * pi * 1e-3
    assert lines[", controller: controller, speed_filter: 0.2 ms}"] == pytest.approx(expected, rel=0.03)


LINE = """
operating_point: {}
measured: cell
rig:
  table: {kind: slide, mass: 4 kg, viscous: 30 N*s/m}
  cell: {kind: force_sensor, stiffness: 2.0e6 N/m, damping: 900 N*s/m, mass: 0.2 kg, bandwidth: 2 kHz,
         sensitivity: 10 mV/N}
  load: {kind: slide, mass: 1.8 kg}
  speed: {kind: probe, quantity: speed, at: load}
"""


def test_a_rig_in_a_line_moves_by_its_recorded_force_in_kg_n_m(tmp_path: Path) -> None:
    """F = 12 N on 6 kg with 30 N s/m: v = F/c (1 - exp(-c t / m)); the cell carries the 2 kg behind it."""
    force = Channel(values=np.full(12_500, 0.012), quantity="force", unit="kN", si_per_unit=1e3)
    write_recording(Recording(sample_rate=25_000.0, channels={"push_kN": force}), tmp_path / "push.parquet")
    push = "push: {kind: replayed_torque, at: table, recording: push.parquet, channel: force}"
    made = simulate(scenario(tmp_path, push, base=LINE).rig, duration=0.5, seed=1, settling=0.0)
    velocity = made.channels["speed_m_s"]
    assert (velocity.quantity, velocity.unit) == ("velocity", "m/s")
    time = made.time()
    expected = 12 / 30 * (1 - np.exp(-5 * time))
    assert velocity.values[2500:] == pytest.approx(expected[2500:], rel=2e-3)  # its mode swings at 190 Hz
    assert made.torque()[-1000:].mean() == pytest.approx((2.0 * 12 / 6 * np.exp(-5 * time))[-1000:].mean(), rel=5e-3)
    assert made.channels[made.torque_name()].quantity == "force"
    assert "true_load_N" in made.channels


@pytest.mark.parametrize(
    ("line", "told"),
    [
        (
            "replay: {kind: replayed_torque, recording: gone.parquet}",
            "rig.replay: .*gone.parquet: there is no such file",
        ),
        ("replay: {kind: replayed_torque, recording: run.parquet, channel: torqe}", "has no channel 'torqe'"),
        (
            "replay: {kind: imposed_motion, recording: run.parquet, channel: current}",
            "is a current, and a motion needs",
        ),
        ("drive: {kind: torque_controller, torque: 9 N*m}", "9 N\\*m are demanded, and the drive of 'motor' gives at"),
        ("drive: {kind: torque_controller, torque: 1 N*m, beside: loop}", "no part 'loop'"),
    ],
)
def test_what_cannot_be_replayed_is_told_with_its_line(
    recorded: Recording, tmp_path: Path, line: str, told: str
) -> None:
    with pytest.raises(InputError, match=rf"rig.yaml:10.*{told}"):
        scenario(tmp_path, line)


def test_a_run_longer_than_its_recording_is_refused_before_it_starts(recorded: Recording, tmp_path: Path) -> None:
    made = scenario(tmp_path, "replay: {kind: replayed_torque, recording: run.parquet}")
    with pytest.raises(InputError, match=r"lasts 0.4 s, and the run 0.5 s; make the run shorter"):
        sensor(made.rig, duration=0.5)
