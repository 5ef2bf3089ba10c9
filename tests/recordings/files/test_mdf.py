"""MDF4 through asammdf where it is installed, and the sentence where it is not; formats that are not read."""

from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files import mdf, open_stream, read_recording
from torquerig.recordings.files.mdf import read_mdf
from torquerig.recordings.files.other_formats import export_for
from torquerig.recordings.files.reading import readers

TIME = np.arange(1000) / 1000
TORQUE = np.round(np.sin(TIME * 90), 6)


def test_without_asammdf_the_sentence_names_the_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mdf, "find_spec", lambda _: None)
    (tmp_path / "run.mf4").write_bytes(b"MDF     4.10")
    with pytest.raises(InputError, match=r"pip install 'torquerig\[mdf\]', or export the run as .mat"):
        read_recording(tmp_path / "run.mf4")


@pytest.mark.parametrize("ending", [".d7d", ".DXD", ".uff", ".mcap", ".xls", ".bin"])
def test_a_format_that_is_not_read_names_the_export(tmp_path: Path, ending: str) -> None:
    (tmp_path / f"run{ending}").write_bytes(b"\0\1\2")
    with pytest.raises(InputError, match=r"is not read; .*(export|save)"):
        read_recording(tmp_path / f"run{ending}")
    assert ending.lower() not in readers()
    assert export_for(".xyz") == ""


def written(path: Path, *groups: dict[str, tuple[np.ndarray, str]], steps: tuple[int, ...] = (1, 1)) -> Path:
    asammdf = pytest.importorskip("asammdf", reason="asammdf is not installed")
    with asammdf.MDF(version="4.10" if path.suffix == ".mf4" else "3.30") as file:
        for group, step in zip(groups, steps, strict=False):
            file.append(
                [
                    asammdf.Signal(values[::step], TIME[::step], name=name, unit=unit, encoding="utf-8")
                    for name, (values, unit) in group.items()
                ]
            )
        file.save(path, overwrite=True)
    return path


# each file is read in a process of its own, which imports asammdf
in_a_process = pytest.mark.long


@in_a_process
@pytest.mark.parametrize("name", ["run.mf4", "run.mdf"])
def test_numbers_units_and_rate(tmp_path: Path, name: str) -> None:
    words = np.array([b"idle"] * 1000)
    group = {"torque": (TORQUE, "Nm"), "count": (np.arange(1000, dtype=np.int32), ""), "state": (words, "")}
    path = written(tmp_path / name, group)
    table = read_mdf(path)
    assert np.array_equal(table.columns["torque"], TORQUE)
    assert table.columns["count"].tolist() == list(range(1000))
    assert table.units["torque"] == "Nm"
    assert table.skipped == {"group 1.state": "texts"}
    recording = read_recording(path)
    assert (recording.sample_rate, open_stream(path).sample_rate) == (1000, 1000)


@in_a_process
@pytest.mark.parametrize(("steps", "rates"), [((1, 10), (1000, 100)), ((2, 5), (500, 200)), ((1, 1), (1000, 1000))])
def test_groups_of_several_rates(tmp_path: Path, steps: tuple[int, int], rates: tuple[int, int]) -> None:
    path = written(tmp_path / "run.mf4", {"torque": (TORQUE, "Nm")}, {"speed": (TORQUE, "rpm")}, steps=steps)
    table = read_mdf(path)
    if steps[0] == steps[1]:
        assert list(table.columns) == ["time", "torque", "speed"]
        return
    assert table.rates == {"torque": rates[0], "speed": rates[1]}
    with pytest.raises(RecordingError, match=rf"torque has {rates[0]} .* speed has {rates[1]}"):
        read_recording(path)


@in_a_process
def test_a_name_in_two_groups_and_invalid_samples(tmp_path: Path) -> None:
    asammdf = pytest.importorskip("asammdf", reason="asammdf is not installed")
    with asammdf.MDF(version="4.10") as file:
        for acquisition in ("fast", "slow"):
            signal = asammdf.Signal(TORQUE, TIME, name="torque", unit="Nm", invalidation_bits=TIME > 0.9)
            file.append([signal], acq_name=acquisition)
        file.save(tmp_path / "run.mf4", overwrite=True)
    table = read_mdf(tmp_path / "run.mf4")
    assert list(table.columns) == ["time", "fast.torque", "slow.torque"]
    assert int(np.isnan(table.columns["fast.torque"]).sum()) == 99


@in_a_process
@pytest.mark.parametrize("size", [0, 10, 64, 200, 900])
def test_a_file_that_is_cut_short(tmp_path: Path, size: int) -> None:
    path = written(tmp_path / "run.mf4", {"torque": (TORQUE, "Nm")})
    path.write_bytes(path.read_bytes()[:size])
    with pytest.raises(RecordingError, match=r"not a whole MDF file|no vector of two"):
        read_recording(path)
