"""A recording or a rig that moves in a line: orders over its travel, units of its motion, remedies."""

from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.cli import main
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE, LEAD = 1000.0, 0.010
TIME = np.arange(12_000) / RATE
AXIS = Path(__file__).resolve().parents[2] / "scenarios" / "linear_axis.yaml"
STROKES = {
    "one stroke": 0.05 * TIME + 0.002 * np.sin(2 * pi * 0.2 * TIME),
    "backwards": -0.05 * TIME + 0.002 * np.sin(2 * pi * 0.2 * TIME),
    "to and fro": 0.25 * np.sin(2 * pi * 0.1 * TIME),
}
PUSH = """
operating_point: {}
measured: sensor
rig:
  actuator: {kind: slide, mass: 2 kg, viscous: 10 N*s/m}
  sensor: {kind: force_sensor, stiffness: 100 N/um, damping: 300 N*s/m, mass: 0.3 kg, sensitivity: 5 mV/N,
           bandwidth: 300 Hz, noise_rms: 0 mV}
  tool: {kind: slide, mass: 3 kg, coulomb: 5 N}
  push: {kind: replayed_torque, at: actuator, from: channel push}
"""


def slide(path, motion="one stroke", *, quantity="position", travel=None):
    """A force with four periods per 10 mm of the place, which a position or a velocity measures."""
    place = STROKES[motion]
    force = 20 + 3 * np.cos(2 * pi * 4 * place / LEAD + 1) + 0.1 * np.random.default_rng(1).normal(size=TIME.size)
    channels = {"force_N": Channel(values=force, quantity="force", unit="N")}
    if quantity == "position":
        channels["x_mm"] = Channel(values=1e3 * place, quantity="position", unit="mm", si_per_unit=1e-3)
    elif quantity == "velocity":
        channels["v"] = Channel(values=np.gradient(place) * RATE, quantity="velocity", unit="m/s")
    write_recording(Recording(sample_rate=RATE, channels=channels, run=Run(travel_per_turn=travel)), path)


def refused(capsys, *arguments):
    with pytest.raises(SystemExit) as left:
        main(tuple(map(str, arguments)))
    assert left.value.code == 2
    return capsys.readouterr().err


@pytest.mark.parametrize("quantity", ["position", "velocity"])
@pytest.mark.parametrize("motion", STROKES)
def test_lines_over_the_place_are_found_where_the_travel_per_turn_is_stated(tmp_path, capsys, motion, quantity):
    slide(tmp_path / "axis.parquet", motion, quantity=quantity, travel=LEAD)
    assert "travel_per_turn_mm: 10" in (tmp_path / "axis.yaml").read_text()
    main(("ordermap", str(tmp_path / "axis.parquet")))
    told = capsys.readouterr().out
    about = " ".join(told.split())
    assert "10 mm each" in about
    assert "mm/s" in about
    assert "rpm" not in about
    line = next(row for row in told[told.index("constant  ") :].splitlines() if row.startswith("order"))
    assert float(line.split()[1]) == pytest.approx(4, rel=2e-3)
    main(("filter", str(tmp_path / "axis.parquet"), "--chain", "order_lines"))
    row = next(row for row in capsys.readouterr().out.splitlines() if row.startswith("order_lines "))
    assert float(row.split()[2]) > 80  # % of the standard deviation


def test_without_the_travel_per_turn_the_remedy_is_that_of_a_slide(tmp_path, capsys):
    path = tmp_path / "axis.parquet"
    slide(path)
    for arguments in (("filter", path), ("filter", path, "--chain", "order_lines")):
        said = refused(capsys, *arguments)
        assert "x_mm measures its motion" in said
        assert "travel_per_turn_mm" in said
        assert "rpm" not in said
    main(("ordermap", str(path)))
    assert "travel_per_turn_mm" in capsys.readouterr().out


def test_a_force_alone_needs_a_motion_too(tmp_path, capsys):
    slide(tmp_path / "axis.parquet", quantity="none")
    assert "record a position or a velocity, and state" in refused(capsys, "filter", tmp_path / "axis.parquet")
    slide(tmp_path / "known.parquet", quantity="none", travel=LEAD)
    said = refused(capsys, "filter", tmp_path / "known.parquet")
    assert "record a position or a velocity" in said
    assert "travel_per_turn_mm" not in said


def test_bands_over_time_are_refused_where_the_slide_comes_back(tmp_path, capsys):
    slide(tmp_path / "axis.parquet", "to and fro", travel=LEAD)
    assert "ends where it began" in refused(capsys, "filter", tmp_path / "axis.parquet")


def test_a_scenario_states_the_travel_per_turn_and_must_not_contradict_it(tmp_path, capsys):
    slide(tmp_path / "axis.parquet")
    main(("ordermap", str(tmp_path / "axis.parquet"), "--scenario", str(AXIS)))
    assert "10 mm each" in " ".join(capsys.readouterr().out.split())
    slide(tmp_path / "other.parquet", travel=0.02)
    said = refused(capsys, "ordermap", tmp_path / "other.parquet", "--scenario", AXIS)
    assert "travel_per_turn_mm: 20" in said
    assert "10 mm" in said


def test_a_simulated_axis_states_its_lead(tmp_path):
    main(("simulate", str(AXIS), "--duration", "0.2 s", "--out", str(tmp_path / "run.parquet")))
    assert read_recording(tmp_path / "run.parquet").run.travel_per_turn == pytest.approx(LEAD)


@pytest.mark.parametrize(
    ("command", "said"),
    [(("size",), "an output_speed, such as 50 mm/s"), (("duty",), "the rig has no motor")],
)
def test_a_slide_that_is_pushed_gets_remedies_that_it_can_follow(tmp_path, capsys, command, said):
    (tmp_path / "push.yaml").write_text(PUSH)
    assert said in refused(capsys, *command, tmp_path / "push.yaml")


def test_a_diagnosis_of_a_pushed_slide_asks_for_its_motion(tmp_path, capsys):
    (tmp_path / "push.yaml").write_text(PUSH)
    channels = {
        "push": Channel(values=np.sin(TIME), quantity="force", unit="N", role="input"),
        "force": Channel(values=np.cos(TIME), quantity="force", unit="N", of="sensor"),
    }
    write_recording(Recording(sample_rate=RATE, channels=channels), tmp_path / "run.parquet")
    said = refused(capsys, "diagnose", tmp_path / "run.parquet", "--scenario", tmp_path / "push.yaml", "--check")
    assert "add motion: {kind: imposed_motion, at: PART, from: channel NAME}" in said


def test_modes_of_a_slide_move_in_a_line(tmp_path, capsys):
    (tmp_path / "push.yaml").write_text(PUSH)
    main(("modes", str(tmp_path / "push.yaml")))
    told = capsys.readouterr().out
    assert "everything moves in a line freely" in told
    assert "rpm" not in told.split("\n", 1)[1]
