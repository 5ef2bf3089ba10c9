"""Files as loggers write them open as they are, or by a drafted sidecar after at most two edits; none is misread."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.recordings.realistic.binary_files_of_loggers import BINARIES
from tests.recordings.realistic.files_of_loggers import TEXTS, Right
from torquerig.cli import main
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.sidecar import sidecar_path

FILES = TEXTS | BINARIES


def edited(path: Path, right: Right) -> None:
    """Draft the sidecar and make its edits."""
    main(("sheet", str(path)))
    draft = sidecar_path(path)
    text = draft.read_text(encoding="utf-8")
    for before, after in right.edits:
        assert before in text, text
        text = text.replace(before, after)
    draft.write_text(text, encoding="utf-8")


@pytest.mark.parametrize("name", FILES)
def test_it_opens_and_says_what_it_is(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ending, make = FILES[name]
    path = tmp_path / f"run{ending}"
    right = make(path)
    assert len(right.edits) <= 2
    main(("info", str(path)))
    assert right.torque in capsys.readouterr().out
    if right.edits:
        edited(path, right)
    recording = read_recording(path)
    assert recording.sample_rate == pytest.approx(right.rate, rel=1e-4)
    assert recording.torque_name() == right.torque
    assert recording.torque().mean() == pytest.approx(right.mean_Nm, abs=0.01)
    assert recording.torque().std() == pytest.approx(np.sqrt((0.3**2 + 0.5**2) / 2), rel=0.02)
    for channel, (quantity, unit, mean) in right.levels.items():
        one = recording.channels[channel]
        assert (one.quantity, one.unit) == (quantity, unit)
        assert one.values.mean() == pytest.approx(mean, abs=0.1)


@pytest.mark.long
@pytest.mark.parametrize("name", FILES)
def test_ordermap_finds_its_lines(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ending, make = FILES[name]
    path = tmp_path / f"run{ending}"
    right = make(path)
    if right.edits:
        edited(path, right)
    capsys.readouterr()
    main(("ordermap", str(path)))
    shown = capsys.readouterr().out
    assert "280" in shown if "no orders" in shown else ("16.8 order" in shown or "16.79" in shown)


def test_there_are_files_of_eight_formats() -> None:
    endings = {ending for ending, _ in FILES.values()}
    assert len(endings) >= 8
    assert len(FILES) >= 40
