"""Ranges below the names are no samples; factors and offsets that may have to be applied are refused."""

from pathlib import Path

import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording


def written(path: Path, between: str, *, separator: str = ",", units: str = "") -> Path:
    rows = "".join(f"{k / 2000:.4f},{2 + k % 7 / 10},{1000 + k % 3}\n" for k in range(100))
    text = f"Time [s],Torque [Nm],Speed [rpm]\n{between}{rows}"
    text = text.replace(" [s]", "").replace(" [Nm]", "").replace(" [rpm]", "") if units else text
    path.write_text((text if not units else text.replace("\n", f"\n{units}\n", 1)).replace(",", separator))
    return path


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("units", ["", "s,Nm,rpm"])
@pytest.mark.parametrize(
    "between", ["Min,-20,0\nMax,20,3000\n", "Range,20,3000\n", ",-20,0\n", ",-20,0\n,20,3000\n", "Factor,1.0,1\n"]
)
def test_ranges_are_no_samples(tmp_path: Path, between: str, separator: str, units: str) -> None:
    path = written(tmp_path / "run1.csv", between, separator=separator, units=units)
    recording = read_recording(path)
    assert recording.sample_rate == 2000
    assert recording.samples == 100
    assert {name: one.unit for name, one in recording.channels.items()} == {"Torque": "Nm", "Speed": "rpm"}
    assert any("are no samples" in note for note in open_stream(path).table.notes)


@pytest.mark.parametrize("label", ["Factor", "Faktor", "Scale", "Gain", "Offset"])
def test_factors_are_asked(tmp_path: Path, label: str) -> None:
    path = written(tmp_path / "run1.csv", f"{label},0.01,0.1\n")
    with pytest.raises(RecordingError, match=rf"run1.csv:2: the row '{label}' holds .*, for example 0.01"):
        read_recording(path)
    assert read_recording(written(path, "")).samples == 100
