"""Each speed has the sign of its own shaft; a sidecar states only what the scenario states or its load depends on."""

from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.recordings.files.sidecar_text import sidecar_text
from torquerig.scenario.drive_requirement import drive_requirement
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

PAIR = """
operating_point: POINT
measured: sensor
rig:
  motor: {kind: motor, inertia: 1 kg*cm^2, torque_limit: 3 N*m}
  stage: {kind: gear, ratio: RATIO, stiffness: 10 kN*m/rad, damping: 1 N*m*s/rad, efficiency: 0.9,
          output_inertia: 5 kg*cm^2}
  sensor: {kind: torque_sensor, stiffness: 10 kN*m/rad, damping: 0.1 N*m*s/rad, inertia: 1 kg*cm^2,
           sensitivity: 1 V/(N*m), bandwidth: 300 Hz, noise_rms: 0 mV}
  drum: {kind: body, inertia: 0.01 kg*m^2, viscous: 0.05 N*m*s/rad}
  weight: {kind: body, inertia: 1.0e-4 kg*m^2}
  controller: {kind: speed_controller, motor: motor, kp: 0.1 N*m*s/rad, ki: 0.3 N*m/rad}
  drum_speed: {kind: probe, quantity: speed, at: drum}
"""
CYCLE = """{profile: duty_cycle, duty_cycle: {segments: [
  {duration: 1 s, output_speed: 100 rpm, load_torque: 2 N*m},
  {duration: 1 s, output_speed: 0 rpm, load_torque: 2 N*m},
  {duration: 1 s, output_speed: -50 rpm, load_torque: 2 N*m}]}}"""
MOVED = """
operating_point: {}
measured: motion
rig:
  carriage: {kind: slide, mass: 10 kg}
  motion: {kind: imposed_motion, at: carriage, channel: position}
"""


def made(text, **words):
    for word, value in words.items():
        text = text.replace(word, value)
    return read_scenario(parse_document(text, Path("rig.yaml")), Catalog(), seed=0)


@pytest.mark.parametrize("speed", ["100 rpm", "-100 rpm"])
def test_a_reversing_gear_keeps_the_sign_of_the_output(speed):
    runs = {}
    for ratio in ("5", "-5"):
        scenario = made(PAIR, RATIO=ratio, POINT=f"{{output_speed: {speed}}}")
        runs[ratio] = simulate(scenario.rig, duration=0.5, settling=1.0, seed=1, sample_rate=1000)
        assert runs[ratio].run.gear_ratio == 5
    assert runs["-5"].run.speed == -runs["5"].run.speed
    sign = -1 if speed.startswith("-") else 1
    for run in runs.values():
        turning = run.channels["drum_speed_rad_s"].values
        assert turning == pytest.approx(sign * 100 * np.pi / 30, rel=0.02)
        assert sign * run.torque().mean() == pytest.approx(0.05 * 100 * np.pi / 30, rel=0.05)


@pytest.mark.parametrize("speed", ["500 rpm", "-500 rpm"])
def test_a_motor_speed_has_the_sign_of_the_motor(speed):
    forth, back = (made(PAIR, RATIO=ratio, POINT=f"{{motor_speed: {speed}}}").rig.run for ratio in ("5", "-5"))
    assert forth.speed == back.speed == pytest.approx(float(speed.split()[0]) * np.pi / 30)


def test_a_duty_cycle_behind_a_reversing_gear_needs_the_mirrored_drive():
    forth, back = (drive_requirement(made(PAIR, RATIO=ratio, POINT=CYCLE).rig, duration=3.0) for ratio in ("5", "-5"))
    assert np.any(forth.torque[forth.speed == 0])  # a torque is held at rest
    assert back.speed == pytest.approx(-forth.speed)
    assert back.torque == pytest.approx(-forth.torque)
    assert back.duration == pytest.approx(forth.duration)


def test_a_moved_rig_states_neither_gear_nor_load():
    run = made(MOVED).rig.run
    assert (run.gear_ratio, run.occupancy_percent, run.particle_size) == (None, None, None)


def test_a_rig_without_a_bed_states_the_load_that_its_scenario_states():
    plain = made(PAIR, RATIO="5", POINT="{output_speed: 60 rpm}").rig.run
    assert (plain.gear_ratio, plain.occupancy_percent, plain.particle_size) == (5, None, None)
    stated = made(PAIR, RATIO="5", POINT="{output_speed: 60 rpm, load: {occupancy: 5 %, particle_size: 1 mm}}").rig.run
    assert (stated.occupancy_percent, stated.particle_size) == (5, 1e-3)


def test_the_sidecar_of_a_rig_without_a_bed_has_no_load():
    rig = made(PAIR, RATIO="-5", POINT="{output_speed: 60 rpm}").rig
    text = sidecar_text(simulate(rig, duration=0.1, settling=0.1, seed=1, sample_rate=1000))
    assert "occupancy" not in text
    assert "particle" not in text
    assert "speed_rpm: -300" in text
