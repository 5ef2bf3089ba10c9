"""`info`, `filter`, `filter` in blocks and `ordermap` print the same sentences about a recording's samples."""

from __future__ import annotations

from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

import numpy as np
import pytest

from torquerig.cli import main
from torquerig.recordings.files import write_recording
from torquerig.recordings.inspection import stretch_faults
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE, SPEED = 5000.0, 1000 * np.pi / 30


@pytest.fixture
def faulty(tmp_path: Path) -> Path:
    """A reading with telegraph noise, from a motor whose encoder loses counts."""
    time = np.arange(int(12 * RATE)) / RATE
    noise = 0.005 * np.random.default_rng(3).standard_normal(time.size)
    high = ((time > 1.1) & (time < 2.0)) | ((time > 4.0) & (time < 7.5)) | ((time > 9.0) & (time < 10.0))
    volts = 1.0 + 0.05 * np.sin(SPEED / 5 * time) + noise + 0.4 * high
    angle = SPEED * time + 1.5 * (time > 6.0)
    channels = {
        "torque_V": Channel(values=volts, quantity="torque", unit="V"),
        "encoder_count": Channel(
            values=np.floor(angle * 8192 / (2 * np.pi)), quantity="motor_angle", unit="count",
            si_per_unit=2 * np.pi / 8192,
        ),
    }  # fmt: skip
    run = Run(motor="bldc-12n14p", gear_ratio=5.0, speed=SPEED)
    write_recording(Recording(sample_rate=RATE, channels=channels, run=run), tmp_path / "run1.parquet")
    return tmp_path / "run1.parquet"


def printed(*arguments: object) -> list[str]:
    with redirect_stdout(StringIO()) as out:
        main(tuple(map(str, arguments)))
    return out.getvalue().splitlines()


def test_all_commands_print_the_same_sentences(faulty: Path) -> None:
    commands = [("info", faulty), ("filter", faulty), ("filter", faulty, "--block", "4 s"), ("ordermap", faulty)]
    each = [[line for line in printed(*command) if line.startswith("suspicious: ")] for command in commands]
    assert each[1:] == each[:1] * 3
    assert len(each[0]) == 2
    assert any("random telegraph" in line and line.startswith("suspicious: torque_V: at 1.1") for line in each[0])
    assert any("encoder_count jumps by up to 0.24 turns" in line for line in each[0])


def test_a_long_recording_is_examined_at_its_start(faulty: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stretch_faults, "STRETCH", int(3 * RATE))
    for command in (("info", faulty), ("ordermap", faulty)):
        lines = printed(*command)
        assert "faults of the torque's samples were sought in the first 3 s" in lines
        assert not any("telegraph" in line for line in lines)
    assert "faults of samples were sought in the first 3 s" in printed("filter", faulty, "--block", "4 s")


def test_times_count_from_the_longest_stretch_of_numbers(tmp_path: Path, faulty: Path) -> None:
    path = tmp_path / "gap.csv"
    values = 1.0 + 0.01 * np.random.default_rng(1).standard_normal(5000)
    rows = [f"{value:.6f}" for value in values]
    rows[1000] = "nan"
    path.write_text("torque_V\n" + "\n".join(rows) + "\n")
    path.with_suffix(".yaml").write_text("sample_rate_Hz: 1000\n")
    lines = printed("info", path)
    assert any("samples 1001..4999" in line and "times count from sample 1001" in line for line in lines)
