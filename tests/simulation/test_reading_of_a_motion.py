"""What an imposed motion takes as the reading of a rig: friction by direction, play in a link, phases of cogging."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

RATE, F, STROKE = 1000.0, 2.0, 0.05  # [Hz], [Hz], [m]
TIME = np.arange(1001) / RATE
SPEED = 2 * np.pi * F * STROKE * np.cos(2 * np.pi * F * TIME)

CARRIAGE = """
operating_point: {}
measured: motion
rig:
  table: {kind: slide, mass: 3 kg, viscous: 20 N*s/m}
  motion: {kind: imposed_motion, at: table, recording: run.parquet, channel: position}
"""
PLAY = """
operating_point: {}
measured: motion
rig:
  table: {kind: slide, mass: 1.0e-3 kg}
  link: {kind: link, stiffness: 1.0e6 N/m, damping: 500 N*s/m}
  brake: {kind: slide, mass: 0.1 kg, coulomb: 40 N, smoothing: 1.0e-4 m/s}
  motion: {kind: imposed_motion, at: table, recording: run.parquet, channel: position}
"""
ROTOR = """
operating_point: {}
measured: motion
rig:
  motor: {kind: motor, inertia: 1.0e-4 kg*m^2, torque_limit: 1 N*m}
  motion: {kind: imposed_motion, at: motor, recording: turn.parquet, channel: angle}
"""


def rig(tmp_path: Path, text: str, *lines: str) -> Rig:
    swing = Channel(values=STROKE * np.sin(2 * np.pi * F * TIME), quantity="position", unit="m")
    write_recording(Recording(sample_rate=RATE, channels={"position_m": swing}), tmp_path / "run.parquet")
    turn = Channel(values=2.0 * TIME, quantity="angle", unit="rad")
    write_recording(Recording(sample_rate=RATE, channels={"angle_rad": turn}), tmp_path / "turn.parquet")
    written = text + "".join(f"  {line}\n" for line in lines)
    return read_scenario(parse_document(written, tmp_path / "rig.yaml"), Catalog(), seed=0).rig


def taken(made: Rig) -> np.ndarray:
    return simulate(made, duration=1.0, seed=0, sample_rate=RATE, settling=0.0).torque()


def test_the_reading_is_what_mass_and_friction_by_direction_ask_for(tmp_path: Path) -> None:
    """m v' + c v + Tc sign(v), c and Tc of the direction, away from the reversals."""
    friction = (
        "friction: {kind: stribeck_friction, at: table, coulomb: 5 N, static: 5 N, stribeck_speed: 1 m/s, "
        "coulomb_backward: 8 N, static_backward: 8 N, viscous: 3 N*s/m, viscous_backward: 30 N*s/m, "
        "smoothing: 1.0e-3 m/s}"
    )
    reading, speed = taken(rig(tmp_path, CARRIAGE, friction)), SPEED[:-1]
    gained = -((2 * np.pi * F) ** 2) * STROKE * np.sin(2 * np.pi * F * TIME[:-1])
    expected = 3 * gained + np.where(speed > 0, 23 * speed + 5, 50 * speed - 8)
    inner = np.abs(speed) > 0.02
    inner[[0, -1]] = False  # the spline ends there
    assert reading[inner] == pytest.approx(expected[inner], abs=0.02)  # cubic between samples, of 23 N


@pytest.mark.long
def test_play_lets_the_actuator_travel_freely_after_each_reversal(tmp_path: Path) -> None:
    """Free travel, by which the force stays below a tenth, is the play and the springs' short way beside it."""
    made = rig(tmp_path, PLAY, "play: {kind: backlash, gear: link, gap: 8 mm}")
    reading = taken(made)
    free = np.abs(reading[100:]) < 4.0
    travelled = np.abs(np.diff(STROKE * np.sin(2 * np.pi * F * TIME)))[100:][free].sum()
    assert travelled / 4 == pytest.approx(8e-3, abs=1e-3)  # four reversals in the second behind 0.1 s


def test_cogging_stands_where_its_phases_say(tmp_path: Path) -> None:
    line = ("cogging: {kind: cogging, at: motor, slots: 18, pole_pairs: 12, native: 30 mN*m, further: {36: 10 mN*m}, "
            "phases: {72: 0.5, 36: -1.0}}")  # fmt: skip
    reading, angle = taken(rig(tmp_path, ROTOR, line)), 2.0 * TIME[:-1]
    expected = -0.03 * np.cos(72 * angle + 0.5) - 0.01 * np.cos(36 * angle - 1.0)
    assert reading[2:-2] == pytest.approx(expected[2:-2], abs=1e-6)  # at constant speed inertia asks for nothing


def test_a_further_line_of_another_cause_is_refused(tmp_path: Path) -> None:
    line = "cogging: {kind: cogging, at: motor, slots: 18, pole_pairs: 12, further: {35: 10 mN*m}}"
    with pytest.raises(InputError, match="35 is no multiple of 18 slots or 24 poles; write a line of another cause"):
        rig(tmp_path, ROTOR, line)
