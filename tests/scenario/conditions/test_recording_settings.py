"""The section ``recording:`` of a scenario reaches every command that samples."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest

import torquerig as tr
from torquerig.catalog.reading import Catalog
from torquerig.cli import main
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.recordings.files import read_recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

RIG = """
scenario: fan
operating_point: {motor_speed: 300 rpm}
RECORDING
rig:
  motor: {kind: motor, inertia: 1.0e-4 kg*m^2, torque_limit: 1 N*m}
  torque_sensor: {kind: torque_sensor, stiffness: 500 N*m/rad, damping: 0.05 N*m*s/rad, inertia: 0.1 kg*cm^2,
    bandwidth: 400 Hz}
  fan: {kind: body, inertia: 1.0e-3 kg*m^2, viscous: 0.01 N*m*s/rad}
  speed_controller: {kind: speed_controller, motor: motor, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}
"""


def made(recording: str) -> Scenario:
    return read_scenario(parse_document(RIG.replace("RECORDING", recording), Path("fan.yaml")), Catalog(), seed=1)


def test_a_stated_recording_is_the_one_simulated() -> None:
    scenario = made("recording: {sample_rate: 2 kHz, duration: 0.5 s, settling: 0.2 s}")
    recording = tr.simulate(scenario)
    assert (recording.sample_rate, recording.samples) == (2000.0, 1000)
    assert tr.modes(scenario).twin.rate == 2000.0


def test_settling_starts_the_recording_later_on_the_same_run() -> None:
    early, late = (tr.simulate(made(f"recording: {{sample_rate: 2 kHz, duration: 0.5 s, settling: {one} s}}"))
                   for one in (0.0, 5.0))  # fmt: skip
    off = [abs(one.channels["true_sensor_torque_Nm"].values[0] / (0.01 * 300 * pi / 30) - 1) for one in (early, late)]
    assert off[1] < 1e-6 < off[0]


def test_it_is_written_with_the_scenario(tmp_path: Path) -> None:
    scenario = made("recording: {sample_rate: 2 kHz, duration: 0.5 s}")
    again = tr.read_scenario(scenario.write(tmp_path / "again.yaml"))
    assert again.recording == scenario.recording


@pytest.mark.parametrize(("written", "words"), [
    ("recording: {sample_rate: 0 Hz}", "recording.sample_rate"),
    ("recording: {sample_rate: 2 s}", "recording.sample_rate"),
    ("recording: {rate: 2 kHz}", "recording.rate"),
    ("recording: 3", "recording"),
])  # fmt: skip
def test_what_cannot_be_used_is_named(written: str, words: str) -> None:
    with pytest.raises(InputError, match=rf"fan\.yaml:4: {words}"):
        made(written)


def test_the_option_rate_goes_before_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rig, out = tmp_path / "fan.yaml", tmp_path / "run.csv"
    rig.write_text(RIG.replace("RECORDING", "recording: {sample_rate: 2 kHz, duration: 0.5 s}"), encoding="utf-8")
    main(["simulate", str(rig), "--rate", "1 kHz", "--out", str(out)])
    assert read_recording(out).sample_rate == 1000.0
    with pytest.raises(SystemExit):
        main(["simulate", str(rig), "--rate", "0 Hz", "--out", str(tmp_path / "b.csv")])
    assert "--rate 0 Hz" in capsys.readouterr().err
