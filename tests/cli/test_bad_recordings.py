"""The issue's bad recordings through both commands: a sentence and exit code 2, or a warning that names the samples."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from nptdms import ChannelObject, TdmsWriter
from scipy.io import savemat

from torquerig.cli import main

RATE, COUNT = 1000, 2000
VALUES = 1 + 0.1 * np.sin(2 * np.pi * 20 * np.arange(COUNT) / RATE)
GAPPY = np.where((np.arange(COUNT) >= 500) & (np.arange(COUNT) < 520), np.nan, VALUES)
TORQUE = "torque_V: {quantity: torque, unit: V, Nm_per_V: 1.0}"
ENCODER = "encoder_count: {quantity: motor_angle, unit: count, counts_per_rev: 4096}"


def csv(*columns: np.ndarray, head: str = "time_s,torque_V") -> str:
    return head + "\n" + "\n".join(",".join(f"{cell:.4f}" for cell in row) for row in zip(*columns, strict=True)) + "\n"


AT = np.arange(COUNT) / RATE


def cut_tdms(path: Path) -> None:
    with TdmsWriter(path) as file:
        file.write_segment([ChannelObject("recording", "torque_V", VALUES)])
    path.write_bytes(path.read_bytes()[:-1000])


def unequal_mat(path: Path) -> None:
    savemat(path, {"torque_V": VALUES, "encoder_count": np.arange(1900.0)})


REFUSED: dict[str, tuple[str, Callable[[Path], object], str]] = {
    "truncated TDMS": ("run.tdms", cut_tdms, "ends in the middle of its last segment"),
    "commas twice": (
        "run.csv", lambda path: path.write_text(csv(AT, VALUES).replace(".", ",")), "separate the cells by semicolons",
    ),
    "broken row": ("run.csv", lambda path: path.write_text(csv(AT, VALUES) + "2.0000\n"), "run.csv:2002: the row has"),
    "no such variable": ("run.mat", lambda path: savemat(path, {"pressure": VALUES}), "known are pressure"),
    "unequal lengths": ("unequal.mat", unequal_mat, "unequal numbers of samples (torque_V 2000, encoder_count 1900)"),
    "wrong rate": ("run.csv", lambda path: path.write_text(csv(2 * AT, VALUES)), "states 1000 samples per second and"),
    "no samples": ("run.csv", lambda path: path.write_text(csv(AT[:0], VALUES[:0])), "has no samples"),
    "one sample": ("run.csv", lambda path: path.write_text(csv(AT[:1], VALUES[:1])), "run.csv: "),
}  # fmt: skip


def said(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    try:
        main(arguments)
    except SystemExit as stopped:
        told = capsys.readouterr()
        return int(stopped.code or 0), told.out, told.err
    told = capsys.readouterr()
    return 0, told.out, told.err


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    run = "run: {motor: REF, gear_ratio: 5, speed_rpm: 300, profile: steady}\n"
    Path("run.yaml").write_text(f"sample_rate_Hz: {RATE}\nchannels:\n  {TORQUE}\n{run}")
    Path("unequal.yaml").write_text(f"sample_rate_Hz: {RATE}\nchannels:\n  {TORQUE}\n  {ENCODER}\n{run}")
    return tmp_path


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_serve_is_refused_in_one_sentence(
    case: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name, make, sentence = REFUSED[case]
    make(folder / name)
    code, out, err = said(capsys, "filter", name)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert sentence in err


# their columns can be read, so info shows them with what prevents their use
SHOWN = ("no such variable", "unequal lengths", "wrong rate", "one sample")


@pytest.mark.parametrize("case", REFUSED)
def test_info_shows_what_can_be_read_and_refuses_the_rest(
    case: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name, make, sentence = REFUSED[case]
    make(folder / name)
    code, out, err = said(capsys, "info", name)
    if case in SHOWN:
        assert (code, err) == (0, "")
        assert sentence in " ".join(out.split())
        assert "cannot be used yet: " in out
    else:
        assert (code, out, err.count("\n")) == (2, "", 1)
        assert sentence in err


def test_decimal_commas_are_read(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "run.csv").write_text(csv(AT, VALUES).replace(",", ";").replace(".", ","))
    assert said(capsys, "info", "run.csv")[0] == 0
    assert said(capsys, "filter", "run.csv")[0] == 0


def test_samples_that_are_no_numbers_are_named(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "run.csv").write_text(csv(AT, GAPPY))
    code, out, _ = said(capsys, "info", "run.csv")
    assert code == 0
    assert "20 samples that are not numbers: samples 500..519" in out
    # the speed comes from the longest stretch that has numbers
    assert "samples 520..1999, the longest stretch" in " ".join(out.split())
    code, out, err = said(capsys, "filter", "run.csv")
    assert (code, out) == (2, "")
    assert "samples 500..519" in err


def test_a_constant_signal_is_warned_of(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "run.csv").write_text(csv(AT, np.full(COUNT, 1.25)))
    code, out, _ = said(capsys, "info", "run.csv")
    assert code == 0
    assert "torque_V is constant at 1.25 V in all its 2000 samples" in out
    code, _, err = said(capsys, "filter", "run.csv")
    assert code == 0
    assert "constant in all its 2000 samples" in err
