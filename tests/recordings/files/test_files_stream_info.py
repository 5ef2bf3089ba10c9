"""``info`` tells of a bad recording what is wrong and where, also where the recording is read in blocks."""

from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet

from torquerig.recordings.files import open_stream, read_recording, write_recording
from torquerig.recordings.files.blocks import Blocking
from torquerig.recordings.inspection import recording_info as info_module
from torquerig.recordings.inspection.recording_info import recording_info, stream_info
from torquerig.recordings.recording import Channel, Recording

COUNT = 40_000


def bad() -> np.ndarray:
    rng = np.random.default_rng(3)
    values = np.convolve(rng.standard_normal(COUNT), np.hanning(30) / 15, mode="same")
    values[1000:1100] = np.nan
    values[7000] = np.inf
    values[12_000] += 9
    values[16_000:16_050] = -7.0
    values[24_000:24_060] = values[24_000]
    return values


TOLD = [
    "torque_V has 101 samples that are not numbers: samples 1000..1099, 7000",
    "torque_V drops to -7 V and comes back 1 time, for 50 to 50 ms: samples 16000..16049",
    "torque_V has 1 spike: sample 12000",
    "torque_V holds one value for 60 samples (0.06 s) from sample 24000 (24 s) on",
]


@pytest.mark.parametrize("size", [2**20, 4096, 2000, 1001])
def test_every_fault_is_named_with_its_samples(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, size: int) -> None:
    parquet.write_table(pa.table({"torque_V": bad()}), tmp_path / "run1.parquet")
    (tmp_path / "run1.yaml").write_text("sample_rate_Hz: 1000\n")
    monkeypatch.setattr(info_module, "Blocking", lambda samples, overlap: Blocking(samples=size, overlap=overlap))
    info = stream_info(open_stream(tmp_path / "run1.parquet"))
    assert info.suspicions() == TOLD
    assert (info.samples, info.duration) == (COUNT, 40.0)
    finite = bad()[np.isfinite(bad())]
    assert info["torque_V"].mean == pytest.approx(finite.mean(), abs=1e-12)
    assert info["torque_V"].std == pytest.approx(finite.std(), rel=1e-12)


def test_gaps_of_time_are_named(tmp_path: Path) -> None:
    times = np.arange(5000) / 1000
    times[3000:] += 0.25
    times[4000:] -= 0.1
    values = np.random.default_rng(0).standard_normal(5000)
    parquet.write_table(pa.table({"time_s": times, "torque_V": values}), tmp_path / "run1.parquet")
    info = stream_info(open_stream(tmp_path / "run1.parquet"))
    assert info.sample_rate == 1000
    assert info.suspicions() == [
        "time_s jumps by 0.251 s instead of 0.001 s after sample 2999 (2.999 s)",
        "time_s jumps by -0.099 s instead of 0.001 s after sample 3999 (4.249 s)",
    ]


@pytest.mark.parametrize("ending", [".parquet", ".csv", ".mat", ".tdms"])
def test_a_stream_and_a_recording_tell_the_same(tmp_path: Path, ending: str) -> None:
    values = np.minimum(np.random.default_rng(1).standard_normal(5000), 1.0)
    made = Recording(
        sample_rate=1000.0, channels={"torque_V": Channel(values=values, quantity="torque", unit="V")}, name="made"
    )
    path, _ = write_recording(made, tmp_path / f"run1{ending}")
    first, second = stream_info(open_stream(path)), recording_info(read_recording(path))
    assert (
        first.suspicions() == second.suspicions() == [f"torque_V looks clipped at 1 V ({(values == 1).sum()} samples)"]
    )
    assert first["torque_V"] == second["torque_V"]
    assert first.as_dict()["samples"] == 5000
