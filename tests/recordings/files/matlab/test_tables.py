"""MATLAB tables and timetables, as mat-io writes them; skipped where it is not installed."""

import warnings
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from tests.recordings.files.matlab.matlab_files import matlab_object, write
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.mat import read_mat

pytestmark = pytest.mark.long  # each file is read in a process of its own
matio = pytest.importorskip("matio", reason="mat-io is not installed")

TIME = np.arange(50) / 1000


def frame(*, is_timetable: bool) -> pd.DataFrame:
    table = pd.DataFrame({"torque_Nm": np.sin(TIME * 90), "speed_rpm": 1000 + TIME, "state": ["on"] * 50})
    if is_timetable:
        table.index = pd.to_timedelta(TIME, unit="s")
        table.index.name = "Time"
        return table
    return table.assign(time_s=TIME)


@pytest.mark.parametrize("version", ["v7", "v7.3"])
@pytest.mark.parametrize("is_timetable", [True, False])
def test_a_table_gives_its_columns(tmp_path: Path, version: str, is_timetable: bool) -> None:
    path = tmp_path / "run.mat"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        matio.save_to_mat(str(path), {"T": frame(is_timetable=is_timetable)}, version=version)
    table = read_mat(path)
    assert sorted(table.columns) == ["speed_rpm", "time_s", "torque_Nm"]
    assert table.skipped == {"T.state": "words or objects"}
    recording = read_recording(path)
    assert recording.sample_rate == 1000
    assert np.allclose(recording.channels["torque_Nm"].values, np.sin(TIME * 90), rtol=1e-15)


def test_a_table_that_mat_io_cannot_read_costs_one_sentence(tmp_path: Path) -> None:
    path = write(tmp_path / "run.mat", {"a": TIME}, "7")
    path.write_bytes(path.read_bytes() + matlab_object("T", "table"))  # without the data of the object
    table = read_mat(path)
    assert list(table.columns) == ["a"]
    assert "that mat-io cannot read; in MATLAB, s = table2struct" in table.skipped["T"]
