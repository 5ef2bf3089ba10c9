"""Text in 8-bit encodings: what is assumed is told, and JSON stays JSON."""

import json
from pathlib import Path

import pytest

from torquerig.cli import main
from torquerig.recordings.files import open_stream

ROWS = "".join(f"{k / 2000:.4f},{2 + k % 7 / 10}\n" for k in range(100))


@pytest.mark.parametrize(
    ("header", "encoding"),
    [("時間 [s],トルク [Nm]", "shift-jis"), ("Время [s],Момент [Nm]", "cp1251"), ("Zeit [s],Kräfte [N]", "latin-1")],
)
def test_the_assumed_encoding_is_told(
    tmp_path: Path, header: str, encoding: str, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "run1.csv"
    path.write_bytes(f"{header}\n{ROWS}".encode(encoding))
    path.with_suffix(".yaml").write_text("sample_rate_Hz: 2000\n")
    assert any("read as Windows-1252" in note for note in open_stream(path).table.notes)
    main(["info", "--json", str(path)])
    assert json.loads(capsys.readouterr().out)["recordings"][0]["problem"] == ""


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "ascii", "utf-16"])
def test_a_known_encoding_needs_no_word(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "run1.csv"
    header = "Time [s],Torque [Nm]" if encoding == "ascii" else "Zeit [s],Kräfte [N]"
    path.write_bytes(f"{header}\n{ROWS}".encode(encoding))
    assert not any("Windows-1252" in note for note in open_stream(path).table.notes)
