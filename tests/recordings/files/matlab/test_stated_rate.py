"""Rates, units and names that the variables of MATLAB files state by their names."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import savemat

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording

T = np.arange(500) / 2000
TORQUE = 2 + np.sin(20 * T)


def written(path: Path, **content: Any) -> Path:
    savemat(path, content)
    return path


@pytest.mark.parametrize(
    "stated",
    [{"Tinterval": 0.0005, "Tstart": -0.1}, {"Ts": 0.0005}, {"fs_kHz": 2}, {"SampleRate": 2000, "fs": 2000},
     {"sampling_rate": "2 kHz"}, {"dt_ms": 0.5}, {"tout": T}],
)  # fmt: skip
def test_a_rate_is_stated_by_its_name(tmp_path: Path, stated: dict[str, Any]) -> None:
    path = written(tmp_path / "run.mat", torque_Nm=TORQUE, **stated)
    assert read_recording(path).sample_rate == pytest.approx(2000)
    assert open_stream(path).sample_rate == pytest.approx(2000)


def test_two_rates_that_contradict_are_refused(tmp_path: Path) -> None:
    path = written(tmp_path / "run.mat", torque_Nm=TORQUE, SampleRate=2000, fs=1000)
    with pytest.raises(RecordingError, match=r"states a rate of .*; correct one of them"):
        read_recording(path)


def test_a_text_states_the_unit_of_the_variable_of_its_name(tmp_path: Path) -> None:
    path = written(
        tmp_path / "run.mat", Torque=TORQUE, Torque_unit="Nm", s={"Speed": 99 + T, "speed_Unit": "rpm"}, fs=2e3
    )
    channels = read_recording(path).channels
    assert (channels["Torque"].quantity, channels["Torque"].unit) == ("torque", "Nm")
    assert channels["Speed"].unit == "rpm"


@pytest.mark.parametrize("frequency", ["2000", "2000 Hz", 2000.0])
def test_headers_of_catman(tmp_path: Path, frequency: object) -> None:
    headers = {"SignalName": "Drehmoment", "Unit": "Nm", "SampleFrequency": frequency}
    slow = {"SignalName": "Drehzahl", "Unit": "U/min", "SampleFrequency": frequency}
    path = written(
        tmp_path / "run.mat",
        Channel_1_Header=headers,
        Channel_1_Data=TORQUE,
        Channel_2_Header=slow,
        Channel_2_Data=99 + T,
    )
    recording = read_recording(path)
    assert recording.sample_rate == 2000
    assert {name: one.unit for name, one in recording.channels.items()} == {"Drehmoment": "Nm", "Drehzahl": "rev/min"}
